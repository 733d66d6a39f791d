#include "player/display/mesa_options.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

using namespace vitrine::player;

namespace {

/// Mesa's variable after the options were set, if the user has set it to these words; nullptr: not at all.
std::string mesa_words(const char* users) {
    if (users != nullptr)
        ::setenv("LP_PERF", users, 1);
    else
        ::unsetenv("LP_PERF");
    set_mesa_options();
    set_mesa_options();
    const std::string words = std::getenv("LP_PERF");
    ::unsetenv("LP_PERF");
    return words;
}

}  // namespace

TEST_CASE("Mesa's software renderer draws without its linear path, and keeps the user's words") {
    CHECK(mesa_words(nullptr) == "no_rast_linear");
    CHECK(mesa_words("") == "no_rast_linear");
    CHECK(mesa_words("no_mipmap") == "no_mipmap,no_rast_linear");
    CHECK(mesa_words("no_rast_linear,no_blend") == "no_rast_linear,no_blend");
    CHECK(mesa_words("all") == "all");
}
