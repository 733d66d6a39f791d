#include "base/wall/wall_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

constexpr std::size_t max_length = 63;  // of a host name's part

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_inner(char c) {
    return is_letter_or_digit(c) || c == '-' || c == '_' || c == '.';
}

}  // namespace

bool is_wall_name(std::string_view name) {
    return !name.empty() && name.size() <= max_length && is_letter_or_digit(name.front()) &&
           std::ranges::all_of(name, is_inner);
}

std::string wall_name_fault(std::string_view name) {
    if (is_wall_name(name)) return "";
    if (name.empty()) return "the name is empty";
    if (name.size() > max_length)
        return fmt::format("the name has {} characters; it has at most {}", name.size(), max_length);
    return fmt::format(
        "'{}' is no name; a name has letters, digits, '-', '_' and '.', a letter or digit first", name);
}

}  // namespace vitrine
