#include "base/settings/output_words.hpp"

#include <charconv>
#include <utility>
#include <vector>

namespace vitrine {

namespace {

constexpr double max_pixels = 2000;
constexpr double max_share = 0.4;
constexpr int min_side = 16;
constexpr int max_side = 16384;  // px, the limit of graphics cards
constexpr double max_hertz = 1000;

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

/// Parses a number from `min` to `max`, without sign or exponent. The whole text must be the number.
template <typename Number> std::optional<Number> number_named(std::string_view text, Number min, Number max) {
    if (text.find_first_not_of("0123456789.") != std::string_view::npos) return std::nullopt;
    Number value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || value < min || value > max) return std::nullopt;
    return value;
}

std::optional<ScreenLength> length_named(std::string_view text) {
    const bool is_share = text.ends_with('%');
    if (is_share) text.remove_suffix(1);
    const auto value = number_named<double>(text, 0, is_share ? max_share * 100 : max_pixels);
    if (!value) return std::nullopt;
    return is_share ? ScreenLength{.share = *value / 100} : ScreenLength{.pixels = *value};
}

std::optional<ModeWish> mode_named(std::string_view text) {
    if (text == "preferred") return ModeWish{};
    const std::size_t at = text.find('@');
    const std::string_view size = text.substr(0, at);
    const std::size_t cross = size.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = number_named<int>(size.substr(0, cross), min_side, max_side);
    const auto height = number_named<int>(size.substr(cross + 1), min_side, max_side);
    if (!width || !height) return std::nullopt;
    ModeWish wish{.width = *width, .height = *height};
    if (at == std::string_view::npos) return wish;
    const auto rate = number_named<double>(text.substr(at + 1), 1, max_hertz);
    if (!rate) return std::nullopt;
    wish.refresh_rate = *rate;
    return wish;
}

/// The parts of "HDMI-A-1 = this"; without "=" the name is empty.
struct Assignment {
    std::string_view output;
    std::string_view value;
};

Assignment assignment(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return {.output = {}, .value = text};
    return {.output = trimmed(text.substr(0, equals)), .value = trimmed(text.substr(equals + 1))};
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

/// "1280x720"
std::optional<ScreenSize> screen_size_named(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = number_named<int>(text.substr(0, cross), min_side, max_side);
    const auto height = number_named<int>(text.substr(cross + 1), min_side, max_side);
    if (!width || !height) return std::nullopt;
    return ScreenSize{.width = *width, .height = *height};
}

}  // namespace

std::optional<std::vector<ScreenSize>> screen_sizes_named(std::string_view text) {
    std::vector<ScreenSize> sizes;
    while (true) {
        const std::size_t plus = text.find('+');
        const std::optional<ScreenSize> size = screen_size_named(text.substr(0, plus));
        if (!size) return std::nullopt;
        sizes.push_back(*size);
        if (plus == std::string_view::npos) return sizes;
        text.remove_prefix(plus + 1);
    }
}

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

const ModeWish& ModeWishes::of(const std::string& output) const {
    const auto found = named.find(output);
    return found == named.end() ? others : found->second;
}

std::optional<ModeWishes> modes_named(std::string_view text) {
    ModeWishes wishes;
    if (trimmed(text).empty()) return wishes;
    bool is_rest_named = false;
    for (const std::string_view part : list(text)) {
        const auto [output, value] = assignment(part);
        const std::optional<ModeWish> mode = mode_named(value);
        if (!mode) return std::nullopt;
        const bool is_for_rest = output.empty() && !part.starts_with('=');
        if (is_for_rest ? std::exchange(is_rest_named, true) : output.empty()) return std::nullopt;
        if (is_for_rest)
            wishes.others = *mode;
        else if (!wishes.named.emplace(output, *mode).second)
            return std::nullopt;
    }
    return wishes;
}

std::optional<std::map<std::string, std::string>> output_folders_named(std::string_view text) {
    std::map<std::string, std::string> folders;
    if (trimmed(text).empty()) return folders;
    for (const std::string_view part : list(text)) {
        const auto [output, folder] = assignment(part);
        if (output.empty() || !is_folder_below(folder)) return std::nullopt;
        if (!folders.emplace(output, folder).second) return std::nullopt;
    }
    return folders;
}

}  // namespace vitrine
