#include "player/display/mesa_options.hpp"

#include <cstdlib>
#include <string>

namespace vitrine::player {

namespace {

/// Adds a word to those that a variable of the environment has.
void add_word(const char* variable, const std::string& word) {
    const char* const given = std::getenv(variable);
    const std::string words = given != nullptr ? given : "";
    if (words == "all" || words.find(word) != std::string::npos) return;  // `all` stands alone
    ::setenv(variable, words.empty() ? word.c_str() : (words + "," + word).c_str(), 1);
}

}  // namespace

void set_mesa_options() {
    add_word("LP_PERF", "no_rast_linear");
    add_word("GALLIVM_PERF", "no_aos_sampling");
}

}  // namespace vitrine::player
