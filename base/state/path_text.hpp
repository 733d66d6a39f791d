#pragma once

#include <string>
#include <string_view>

// Paths are any bytes, JSON is UTF-8. A path that is not UTF-8 is written into JSON a second time, in hex
// digits.

namespace vitrine {

/// Makes the letters of ASCII small, in every locale; all other bytes stay.
std::string lower_case(std::string_view text);

bool is_utf8(std::string_view text);

std::string to_hex(std::string_view bytes);

/// @throws std::runtime_error if these are no pairs of lower-case hex digits
std::string from_hex(std::string_view hex);

/// True for the path of the inbox, a folder at the root whose files are never shown, and of all that lies in
/// it: "_INBOX", in upper or lower case.
bool is_in_inbox(std::string_view path);

}  // namespace vitrine
