#include "base/state/word_picture.hpp"

#include "base/state/name_hash.hpp"

#include <fmt/format.h>

namespace vitrine {

namespace {

constexpr std::string_view caption_mark = "\x02";  // names of folders hardly begin so
constexpr std::string_view code_mark = "\x03";

}  // namespace

std::filesystem::path word_folder(const std::filesystem::path& state) {
    return state / "words";
}

std::string caption_key(std::string_view text, int lines) {
    return fmt::format("{}{}{}", caption_mark, lines, text);
}

std::optional<CaptionForm> caption_of_key(std::string_view key) {
    if (!key.starts_with(caption_mark) || key.size() <= caption_mark.size()) return std::nullopt;
    const int lines = key[caption_mark.size()] - '0';
    if (lines < 1 || lines > caption_forms) return std::nullopt;
    return CaptionForm{.text = std::string(key.substr(caption_mark.size() + 1)), .lines = lines};
}

std::string code_key(std::string_view text) {
    return fmt::format("{}{}", code_mark, text);
}

std::optional<std::string> code_of_key(std::string_view key) {
    if (!key.starts_with(code_mark)) return std::nullopt;
    return std::string(key.substr(code_mark.size()));
}

std::filesystem::path word_picture(const std::filesystem::path& state, std::string_view text) {
    return word_folder(state) / (name_hash(text) + ".png");
}

}  // namespace vitrine
