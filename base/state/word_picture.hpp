#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

// Words on the wall come as pictures, which the analyzer sets and the player shows: docs/catalogue.md,
// "Words".

/// The folder of these pictures. @param state  the state directory
std::filesystem::path word_folder(const std::filesystem::path& state);

/// A caption is set in several forms, so that one of them has room: in one line, two and three.
constexpr int caption_forms = 3;

/// The name of the picture of a caption, in place of a text. @param lines  1 to caption_forms
std::string caption_key(std::string_view text, int lines);

/// A caption in one of its forms.
struct CaptionForm {
    std::string text;
    int lines = 1;
};

/// The caption of a caption_key(). None: it is an ordinary text.
std::optional<CaptionForm> caption_of_key(std::string_view key);

/// The name of the picture of a QR code, in place of a text: a pixel a module, with a quiet zone.
std::string code_key(std::string_view text);

/// The text of a code_key(). None: it is an ordinary text or a caption.
std::optional<std::string> code_of_key(std::string_view key);

/// The size of the letters in the pictures, px.
constexpr int word_letters = 64;

/// The picture of a line of text: a PNG (RGBA).
/// @param state  the state directory
/// @param text   any bytes
std::filesystem::path word_picture(const std::filesystem::path& state, std::string_view text);

}  // namespace vitrine
