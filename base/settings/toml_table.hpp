#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Texts like "[=show]" break conditions that the parser asserts. Here such a broken assertion becomes an
// error about the text. With NDEBUG the parser ignores TOML_ASSERT and assumes that these cases are
// impossible.
#ifdef NDEBUG
#error "toml++ must not be built with NDEBUG: texts of strangers would be undefined behaviour"
#endif

namespace vitrine {

/// Replaces the assertions of the parser. @throws std::invalid_argument if one does not hold
constexpr void expect_toml(bool holds) {
    if (!holds) throw std::invalid_argument("this is no TOML: a name is missing");
}

}  // namespace vitrine

#define TOML_ASSERT(expr) ::vitrine::expect_toml(static_cast<bool>(expr))
#include <toml++/toml.h>

namespace vitrine {

/// A text is not TOML.
struct TomlError : std::runtime_error {
    TomlError(unsigned at, const std::string& what) : std::runtime_error(what), line(at) {}

    unsigned line;  // counted from 1
};

/// Parses TOML. Nothing else calls toml++. @param source  name of the text in toml++'s places
/// @throws TomlError
toml::table toml_table(std::string_view text, const std::string& source);

/// Reads each key of a TOML text by itself, so that a fault in one does not affect the others.
/// @param source  name of the text
/// @param read    reads one key and returns its fault; empty: it has none
/// @return        the faults, each with source and line; one if the text is no TOML
std::vector<std::string>
faults_in_keys(std::string_view text, const std::string& source,
               const std::function<std::string(std::string_view key, const toml::node& node)>& read);

}  // namespace vitrine
