#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine::analyzer {

/// The lettering of a line, px.
struct LineStyle {
    int letters = 64;         // size of the font
    int height = 100;         // of the picture
    int side = 28;            // between the plate's ends and the letters
    int max_width = 1024;     // of the letters; a longer line ends with an ellipsis
    double shade = 0.65;      // opacity of the plate
    int lines = 1;            // of a caption, about alike in length; more where the letters need it
    bool is_caption = false;  // it may have several lines; the plate becomes as high as they need
};

/// Sets one line of text in white on a dark plate with round corners and writes it as PNG (RGBA), as a whole
/// or not at all. The plate keeps a contrast of at least 4.5 : 1 (WCAG 2.1, 1.4.3) over any picture. Scripts
/// from right to left and letters of several fonts come as pango sets them. Bytes that are not UTF-8 become
/// replacement characters, line breaks become spaces.
/// @throws std::runtime_error, std::system_error naming the file, if it cannot be drawn or written
void write_line_picture(std::string_view text, const std::filesystem::path& file,
                        const LineStyle& style = {});

/// Writes a text as a QR code (ISO/IEC 18004, correction of level M): black modules of one pixel each on
/// white, with a quiet zone of four modules, as PNG (RGBA), as a whole or not at all.
/// @param text  without zero bytes
/// @throws std::runtime_error, std::system_error naming the file, if the text is empty or too long for a
/// code, or the file cannot be written
void write_code_picture(const std::string& text, const std::filesystem::path& file);

}  // namespace vitrine::analyzer
