#include "player/display/mesa_options.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

using namespace vitrine::player;

namespace {

/// A variable of Mesa after the options were set, if the user has set it to these words; nullptr: not at all.
std::string mesa_words(const char* variable, const char* users) {
    if (users != nullptr)
        ::setenv(variable, users, 1);
    else
        ::unsetenv(variable);
    set_mesa_options();
    set_mesa_options();
    const std::string words = std::getenv(variable);
    ::unsetenv(variable);
    return words;
}

}  // namespace

TEST_CASE("Mesa's software renderer draws without its linear path, and keeps the user's words") {
    CHECK(mesa_words("LP_PERF", nullptr) == "no_rast_linear");
    CHECK(mesa_words("LP_PERF", "") == "no_rast_linear");
    CHECK(mesa_words("LP_PERF", "no_mipmap") == "no_mipmap,no_rast_linear");
    CHECK(mesa_words("LP_PERF", "no_rast_linear,no_blend") == "no_rast_linear,no_blend");
    CHECK(mesa_words("LP_PERF", "all") == "all");
}

TEST_CASE("Mesa's software renderer reads textures without steps of 8 bits") {
    CHECK(mesa_words("GALLIVM_PERF", nullptr) == "no_aos_sampling");
    CHECK(mesa_words("GALLIVM_PERF", "no_opt") == "no_opt,no_aos_sampling");
}
