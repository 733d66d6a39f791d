#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vitrine {

/// The ending of a file beside a medium that holds its caption: the medium's whole name, then this.
constexpr std::string_view caption_file_ending = ".txt";

constexpr std::size_t max_caption_bytes = 500;

/// True for the name of such a file: "lake.jpg.txt". Other texts, such as "notes.txt", are none.
bool is_caption_file(std::string_view name);

/// The ending of a file beside a medium that holds the text of its QR code.
constexpr std::string_view code_file_ending = ".url.txt";

constexpr std::size_t max_code_bytes = 250;  // a code of 73 modules a side with its quiet zone

/// True for the name of such a file: "lake.jpg.url.txt".
bool is_code_file(std::string_view name);

/// A caption as it is set, or the reason why it is not.
struct CaptionText {
    std::string text;   // one line of UTF-8 without control characters; empty: there is none
    std::string fault;  // empty: there is none
};

/// Reads a caption. Line breaks become spaces. @param bytes  any
CaptionText caption_text(std::string_view bytes);

/// Reads the text of a QR code in the same way. No text is a fault. @param bytes  any
CaptionText code_text(std::string_view bytes);

}  // namespace vitrine
