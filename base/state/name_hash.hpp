#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vitrine {

constexpr std::size_t name_hash_length = 32;

/// A name for any text: 128 bits of its SHA-256, as 32 hex digits. Whoever chooses texts cannot find one that
/// has the name of another.
std::string name_hash(std::string_view text);

}  // namespace vitrine
