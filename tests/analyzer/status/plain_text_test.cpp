#include "analyzer/status/plain_text.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace vitrine;
using namespace vitrine::analyzer;

TEST_CASE("what people write stays as it is") {
    for (const char* text :
         {"summer/lake.jpg", "Größe ½ – 夏.jpg", "\xf0\x9f\x8e\x84.jpg", "a'b\"c&d<e>", ""})
        CHECK(plain_text(text) == text);
}

TEST_CASE("a name is one line, whatever its bytes") {
    CHECK(plain_text("a\nb\r\tc\x7f") == "a\\x0ab\\x0d\\x09c\\x7f");
    CHECK(plain_text("a\xc2\x85z") == "a\\x85z");                         // next line
    CHECK(plain_text("a\xe2\x80\xa8z") == "a\xef\xbf\xbdz");              // line separator
    CHECK(plain_text("a\xe2\x80\xaegpj.exe") == "a\xef\xbf\xbdgpj.exe");  // turns the direction
}

TEST_CASE("what is not UTF-8 is replaced byte by byte") {
    const std::string mark = "\xef\xbf\xbd";
    CHECK(plain_text("\xff\xfe") == mark + mark);
    CHECK(plain_text("a\xc3") == "a" + mark);
    CHECK(plain_text("\xc0\xaf") == mark + mark);             // '/' in two bytes
    CHECK(plain_text("\xed\xa0\x80") == mark + mark + mark);  // half of a pair of UTF-16
    CHECK(plain_text("\xf4\x90\x80\x80") == mark + mark + mark + mark);
    CHECK(plain_text("\xe4z") == mark + "z");
}

TEST_CASE("in HTML a name can be nothing but text") {
    CHECK(html_text("<script>alert('x')</script>&\"") ==
          "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&amp;&quot;");
    std::mt19937 engine(3);
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes(engine() % 12, ' ');
        for (char& c : bytes)
            c = static_cast<char>(engine());
        const std::string html = html_text(bytes);
        CHECK(html.find_first_of(std::string_view("<>\"'\n\r\0", 7)) == std::string::npos);
        CHECK(plain_text(html) == html);
    }
}
