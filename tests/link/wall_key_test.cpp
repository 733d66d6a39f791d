#include "link/wall_key.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::link;

TEST_CASE("a key is one line of 64 hexadecimal digits") {
    const TemporaryDirectory folder;
    const std::string key = "0123456789abcdefABCDEF" + std::string(42, '0');
    CHECK(read_wall_key(folder.write("key", key + "\n")) == key);
    CHECK(read_wall_key(folder.write("dos", key + "\r\n")) == key);
}

TEST_CASE("a file that is no key is told with its name, and its content is not") {
    const TemporaryDirectory folder;
    const std::string digits(64, 'a');
    for (const std::string& text :
         {std::string(), digits.substr(1), digits + "a", std::string(64, 'g'), digits + "\n" + digits,
          "0x" + digits.substr(2), std::string(100000, 'a')}) {
        const auto file = folder.write("bad.key", text);
        try {
            read_wall_key(file);
            FAIL("a key was read");
        } catch (const std::runtime_error& error) {
            CHECK(std::string(error.what()).find("bad.key") != std::string::npos);
            CHECK(std::string(error.what()).find("aaaa") == std::string::npos);
        }
    }
    CHECK_THROWS_AS(read_wall_key(folder.path / "none"), std::runtime_error);
}
