#include "player/display/mesa_options.hpp"

#include <cstdlib>
#include <string>

namespace vitrine::player {

namespace {

constexpr const char* mesa_variable = "LP_PERF";
constexpr const char* no_linear_path = "no_rast_linear";

}  // namespace

void set_mesa_options() {
    const char* const given = std::getenv(mesa_variable);
    const std::string words = given != nullptr ? given : "";
    if (words == "all" || words.find(no_linear_path) != std::string::npos) return;  // `all` stands alone
    const std::string all = words.empty() ? no_linear_path : words + "," + no_linear_path;
    ::setenv(mesa_variable, all.c_str(), 1);
}

}  // namespace vitrine::player
