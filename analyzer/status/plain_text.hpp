#pragma once

#include <string>
#include <string_view>

namespace vitrine::analyzer {

/// Any bytes, as a file's name may have them, as one line of UTF-8: control characters are written out,
/// "\x0a"; bytes that are not UTF-8 become U+FFFD.
std::string plain_text(std::string_view bytes);

/// The same for HTML, in text and in quoted attributes.
std::string html_text(std::string_view bytes);

}  // namespace vitrine::analyzer
