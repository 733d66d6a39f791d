#pragma once

#include <string>
#include <string_view>

// Names are any bytes: how they stand in what people read.

namespace vitrine::analyzer {

/// One line of UTF-8: control characters are written out, "\x0a", what is not UTF-8 becomes U+FFFD.
std::string plain_text(std::string_view bytes);

/// The same, to stand in HTML, in text as in quoted attributes.
std::string html_text(std::string_view bytes);

}  // namespace vitrine::analyzer
