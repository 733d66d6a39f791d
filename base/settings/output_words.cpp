#include "base/settings/output_words.hpp"

#include <charconv>
#include <vector>

namespace vitrine {

namespace {

constexpr double most_pixels = 2000;
constexpr double most_share = 0.4;

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string_view> list(std::string_view text) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t comma = text.find(',');
        parts.push_back(trimmed(text.substr(0, comma)));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

std::optional<ScreenLength> length_named(std::string_view text) {
    const bool is_share = text.ends_with('%');
    if (is_share) text.remove_suffix(1);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
    if (error != std::errc() || stop != end || !(value >= 0)) return std::nullopt;
    if (value > (is_share ? most_share * 100 : most_pixels)) return std::nullopt;
    return is_share ? ScreenLength{.share = value / 100} : ScreenLength{.pixels = value};
}

bool is_folder_below(std::string_view folder) {
    if (folder.empty() || folder.ends_with('/')) return false;
    for (std::string_view rest = folder; !rest.empty();) {
        const std::size_t slash = rest.find('/');
        const std::string_view part = rest.substr(0, slash);
        if (part.empty() || part == "." || part == "..") return false;
        rest.remove_prefix(slash == std::string_view::npos ? rest.size() : slash + 1);
    }
    return true;
}

}  // namespace

std::optional<Margins> margins_named(std::string_view text) {
    if (trimmed(text).empty()) return Margins{};
    std::vector<ScreenLength> sides;
    for (const std::string_view part : list(text)) {
        const std::optional<ScreenLength> side = length_named(part);
        if (!side) return std::nullopt;
        sides.push_back(*side);
    }
    if (sides.size() == 1) sides.resize(4, sides.front());
    if (sides.size() != 4) return std::nullopt;
    return Margins{sides[0], sides[1], sides[2], sides[3]};
}

std::optional<std::map<std::string, std::string>> output_folders_named(std::string_view text) {
    std::map<std::string, std::string> folders;
    if (trimmed(text).empty()) return folders;
    for (const std::string_view part : list(text)) {
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos) return std::nullopt;
        const std::string_view output = trimmed(part.substr(0, equals));
        const std::string_view folder = trimmed(part.substr(equals + 1));
        if (output.empty() || !is_folder_below(folder)) return std::nullopt;
        if (!folders.emplace(output, folder).second) return std::nullopt;
    }
    return folders;
}

}  // namespace vitrine
