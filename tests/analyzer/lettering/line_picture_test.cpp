#include "analyzer/lettering/line_picture.hpp"

#include "analyzer/lettering/set_words.hpp"
#include "base/state/word_picture.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cairo/cairo.h>
#include <pango/pangocairo.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

constexpr const char* home_of_other = "VITRINE_TEST_HOME";  // variable with the folder of another process

/// A picture of words as it lies on a white picture: the hardest ground for white letters.
struct OnWhite {
    explicit OnWhite(const fs::path& file)
        : surface(cairo_image_surface_create_from_png(file.c_str()), &cairo_surface_destroy),
          width(cairo_image_surface_get_width(surface.get())),
          height(cairo_image_surface_get_height(surface.get())) {
        REQUIRE(cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS);
    }

    /// In [0, 1].
    double grey(int x, int y) const {
        std::uint32_t argb = 0;
        std::memcpy(&argb,
                    cairo_image_surface_get_data(surface.get()) +
                        static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface.get()) +
                        4L * x,
                    sizeof(argb));
        return ((argb & 0xFFU) + (255 - (argb >> 24U))) / 255.0;
    }

    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface;
    int width;
    int height;
};

/// WCAG 2.1, relative luminance of a grey.
double luminance(double grey) {
    return grey <= 0.04045 ? grey / 12.92 : std::pow((grey + 0.055) / 1.055, 2.4);
}

/// The columns in which letters are seen.
std::set<int> inked_columns(const OnWhite& words) {
    std::set<int> inked;
    for (int x = words.height / 4; x < words.width - words.height / 4; ++x)
        for (int y = 0; y < words.height; ++y)
            if (words.grey(x, y) > 0.9) inked.insert(x);
    return inked;
}

OnWhite set(const TemporaryDirectory& home, std::string_view text) {
    const fs::path file = home.path / "words.png";
    write_line_picture(text, file);
    return OnWhite(file);
}

}  // namespace

TEST_CASE("letters on the plate have a contrast of 4.5 : 1 over white") {
    const TemporaryDirectory home;
    const OnWhite words = set(home, "Holidays");
    double lightest = 0;
    double darkest = 1;
    for (int x = words.height / 2; x < words.width - words.height / 2; ++x)
        for (int y = words.height / 8; y < words.height * 7 / 8; ++y) {
            lightest = std::max(lightest, words.grey(x, y));
            darkest = std::min(darkest, words.grey(x, y));
        }
    CHECK((luminance(lightest) + 0.05) / (luminance(darkest) + 0.05) >= 4.5);
    CHECK(inked_columns(words).size() > 100);
}

TEST_CASE("letters keep clear of the plate's edges, and long lines end in time") {
    const TemporaryDirectory home;
    const OnWhite high = set(home, "ÅÇgjpqy|");
    for (int x = high.height / 4; x < high.width - high.height / 4; ++x) {
        CHECK(high.grey(x, 0) < 0.9);
        CHECK(high.grey(x, high.height - 1) < 0.9);
    }
    const OnWhite wide = set(home, std::string(200, 'W'));
    CHECK(wide.width <= LineStyle{}.max_width + 2 * LineStyle{}.side);
    CHECK(wide.width > LineStyle{}.max_width / 2);
}

TEST_CASE("a caption has several lines where it is wanted, with the same letters and contrast") {
    const TemporaryDirectory home;
    int width = 1 << 20, height = 0;
    for (int lines = 1; lines <= caption_forms; ++lines) {
        const fs::path file = home.path / fmt::format("{}.png", lines);
        write_line_picture("Party in the garden", file, {.lines = lines, .is_caption = true});
        const OnWhite caption(file);
        CHECK(caption.width < width);
        CHECK(caption.height > height + LineStyle{}.letters / 2);
        CHECK(inked_columns(caption).size() > 40);
        double lightest = 0, darkest = 1;
        for (int x = caption.width / 4; x < caption.width * 3 / 4; ++x)
            for (int y = 2; y < caption.height - 2; ++y) {
                lightest = std::max(lightest, caption.grey(x, y));
                darkest = std::min(darkest, caption.grey(x, y));
            }
        CHECK((luminance(lightest) + 0.05) / (luminance(darkest) + 0.05) >= 4.5);
        width = caption.width;
        height = caption.height;
    }
    for (const std::string& text : {std::string(500, 'W'), std::string(), std::string("\xd7\xa9 \xd7\x9c")}) {
        const fs::path file = home.path / fmt::format("long {}.png", text.size());
        write_line_picture(text, file, {.lines = 3, .is_caption = true});
        CHECK(OnWhite(file).width <= LineStyle{}.max_width + LineStyle{}.side * 2);
        CHECK(OnWhite(file).height <= 6 * LineStyle{}.height);
    }
}

TEST_CASE("the name of a caption's picture tells its form") {
    const auto form = caption_of_key(caption_key("lake", 2));
    REQUIRE(form);
    CHECK(form->text == "lake");
    CHECK(form->lines == 2);
    CHECK(!caption_of_key("lake"));
    CHECK(!caption_of_key("2lake"));
}

TEST_CASE("any bytes can be set") {
    const TemporaryDirectory home;
    for (const std::string_view text : {"\xff\xfe", "a\nb", "", "<b>&amp;", "ܫܠܡܐ", "שלום", "日本", "🎉"}) {
        CAPTURE(text);
        CHECK(set(home, text).height == LineStyle{}.height);
    }
    CHECK(inked_columns(set(home, "a\nb")).size() == inked_columns(set(home, "a b")).size());
    CHECK(inked_columns(set(home, "<b>")).size() > 40);
}

TEST_CASE("the fonts that come with Vitrine have letters for names in many scripts") {
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 1, 1), &cairo_surface_destroy);
    const std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo(cairo_create(surface.get()), &cairo_destroy);
    for (const char* text : {"Žofín", "Αθήνα", "Київ", "שלום", "سلام", "नमस्ते", "สวัสดี", "東京", "アルバム",
                             "ひらがな", "假期", "서울", "🎉"}) {
        CAPTURE(text);
        const std::unique_ptr<PangoLayout, void (*)(void*)> line(pango_cairo_create_layout(cairo.get()),
                                                                 &g_object_unref);
        pango_layout_set_text(line.get(), text, -1);
        CHECK(pango_layout_get_unknown_glyphs_count(line.get()) == 0);
    }
}

/// The next case runs it in a process of its own.
TEST_CASE("one process sets words and then tries to get out" * doctest::skip()) {
    const char* const home = std::getenv(home_of_other);
    REQUIRE(home != nullptr);
    Settings settings;
    settings.state.directory = (fs::path(home) / "state").string();
    set_words(std::array<std::string, 2>{"Holidays", "שלום"}, settings);
    const fs::path secret = fs::path(home) / "secret";
    const bool reaches = ::access(secret.c_str(), F_OK) == 0 && fopen(secret.c_str(), "r") != nullptr;
    const bool starts = fork() >= 0;
    _exit(reaches ? 3 : starts ? 4 : 0);
}

/// The other process is the same program, started anew: the cases before have left a thread of Pango's, which
/// may hold the allocator's lock while this one forks. Then the other one would wait for ever.
TEST_CASE("words are set in a sandbox that reads fonts and writes pictures only") {
    const TemporaryDirectory home;
    home.write("secret", "x");
    ::setenv(home_of_other, home.path.c_str(), 1);
    const pid_t child = fork();
    if (child == 0) {
        ::execl("/proc/self/exe", "lettering_test", "--no-skip", "--test-case=one process sets words*",
                nullptr);
        _exit(127);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WEXITSTATUS(status) == 0);
    const OnWhite words(word_picture(home.path / "state", "Holidays"));
    CHECK(inked_columns(words).size() > 100);
    CHECK(fs::exists(word_picture(home.path / "state", "שלום")));
}

TEST_CASE("a QR code is black on white, with a quiet zone of four modules") {
    const TemporaryDirectory home;
    write_code_picture("https://example.org/lake", home.path / "code.png");
    const OnWhite code(home.path / "code.png");
    CHECK(code.width == code.height);
    CHECK((code.width - 8 - 17) % 4 == 0);  // ISO/IEC 18004: 17 + 4 modules a version
    for (int at = 0; at < code.width; ++at)
        for (const int edge : {0, 3, code.width - 4, code.width - 1}) {
            CHECK(code.grey(at, edge) == 1);
            CHECK(code.grey(edge, at) == 1);
        }
    for (int x = 4; x < 11; ++x)  // the edge of a finder pattern
        CHECK(code.grey(x, 4) == 0);
    CHECK(code.grey(5, 5) == 1);
    CHECK(code.grey(7, 7) == 0);
}

TEST_CASE("a text too long for a QR code is a fault, not half a code") {
    const TemporaryDirectory home;
    CHECK_THROWS_AS(write_code_picture(std::string(3000, 'a'), home.path / "code.png"), std::runtime_error);
    CHECK(!fs::exists(home.path / "code.png"));
}
