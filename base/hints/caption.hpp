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

/// A caption as it is set, or the reason why it is not.
struct CaptionText {
    std::string text;   // one line of UTF-8 without control characters; empty: there is none
    std::string fault;  // empty: there is none
};

/// Reads a caption. Line breaks become spaces. @param bytes  any
CaptionText caption_text(std::string_view bytes);

}  // namespace vitrine
