#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

// What the parser takes for granted of a text, and texts like "[=show]" break, is an error of the text. With
// NDEBUG the parser would take it for impossible instead, whatever TOML_ASSERT is.
#ifdef NDEBUG
#error "toml++ must not be built with NDEBUG: texts of strangers would be undefined behaviour"
#endif

namespace vitrine {

/// What the parser asserts. @throws std::invalid_argument where it does not hold
constexpr void expect_toml(bool holds) {
    if (!holds) throw std::invalid_argument("this is no TOML: a name is missing");
}

}  // namespace vitrine

#define TOML_ASSERT(expr) ::vitrine::expect_toml(static_cast<bool>(expr))
#include <toml++/toml.h>

namespace vitrine {

/// A text that is not TOML.
struct TomlError : std::runtime_error {
    TomlError(unsigned at, const std::string& what) : std::runtime_error(what), line(at) {}

    unsigned line;  // from 1 on
};

/// The only way to toml++. @param source  what the places in the text are called
/// @throws TomlError
toml::table toml_table(std::string_view text, const std::string& source);

}  // namespace vitrine
