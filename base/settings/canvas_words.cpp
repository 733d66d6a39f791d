#include "base/settings/canvas_words.hpp"

#include "base/geometry/box.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace vitrine {

namespace {

constexpr double farthest = 1e6;         // units from the origin
constexpr double min_length = 16;        // units of a side
constexpr std::size_t max_outputs = 16;  // on one canvas
constexpr std::string_view blanks = " \t\n";

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The parts of a text between separators.
std::vector<std::string_view> parts_of(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find_first_of(separators);
        if (const std::string_view part = without_blanks(text.substr(0, end)); !part.empty())
            parts.push_back(part);
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

/// Thrown within this file. The message is a sentence for the operator.
struct CanvasFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::optional<double> length_of(std::string_view text, double min) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
    if (value < min || value > farthest) return std::nullopt;
    return value;
}

/// Two lengths around a sign, such as "1960,0" or "698x393".
std::optional<Vec2> pair_of(std::string_view text, char sign, double min) {
    const std::size_t at = text.find(sign);
    if (at == std::string_view::npos) return std::nullopt;
    const auto x = length_of(text.substr(0, at), min);
    const auto y = length_of(text.substr(at + 1), min);
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

int turn_of(std::string_view output, std::string_view word) {
    for (const auto& [name, degrees] :
         {std::pair{"0", 0}, std::pair{"90", 90}, std::pair{"180", 180}, std::pair{"270", 270}})
        if (word == name) return degrees;
    throw CanvasFault(
        fmt::format("'{}' is turned by '{}'; it can be turned by 0, 90, 180 or 270", output, word));
}

/// "HDMI-A-1 0,0 698x393 turned 90"
OutputPlace place_of(std::string_view text) {
    const std::vector<std::string_view> words = parts_of(text, blanks);
    OutputPlace place{.output = std::string(words.front())};
    if (words.size() < 2)
        throw CanvasFault(fmt::format("'{}' has no place, such as \"{} 1960,0\"", words[0], words[0]));
    const auto at = pair_of(words[1], ',', -farthest);
    if (!at)
        throw CanvasFault(
            fmt::format("'{}' is no place of '{}'; a place is like \"1960,0\"", words[1], words[0]));
    place.at = *at;
    for (std::size_t k = 2; k < words.size(); ++k) {
        const auto size = pair_of(words[k], 'x', min_length);
        if (size && !place.size) {
            place.size = size;
        } else if (words[k] == "turned" && k + 1 < words.size() && !place.turned) {
            place.turned = turn_of(words[0], words[++k]);
        } else {
            throw CanvasFault(fmt::format("the word '{}' of '{}' is not understood; after its place come its "
                                          "size, like \"698x393\", and its turn, like \"turned 90\"",
                                          words[k], words[0]));
        }
    }
    return place;
}

void check_pair(const OutputPlace& a, const OutputPlace& b) {
    if (a.output == b.output) throw CanvasFault(fmt::format("'{}' is there twice", a.output));
    if (a.at == b.at) throw CanvasFault(fmt::format("'{}' and '{}' are at one place", a.output, b.output));
    if (!a.size || !b.size) return;
    if (!intersection({a.at, a.at + *a.size}, {b.at, b.at + *b.size}).is_empty())
        throw CanvasFault(fmt::format("'{}' and '{}' overlap", a.output, b.output));
}

/// Removes the unit before the places. @return true: millimetres
bool take_unit(std::string_view& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return false;
    const std::string_view unit = without_blanks(text.substr(0, colon));
    if (unit != "mm" && unit != "px")
        throw CanvasFault(fmt::format("'{}' is no unit; it is \"mm\" or \"px\"", unit));
    text.remove_prefix(colon + 1);
    return unit == "mm";
}

std::vector<OutputPlace> places_of(std::string_view text) {
    const bool is_millimetres = take_unit(text);
    std::vector<OutputPlace> places;
    for (const std::string_view part : parts_of(text, ";")) {
        const OutputPlace place = place_of(part);
        if (is_millimetres && !place.size)
            throw CanvasFault(
                fmt::format("'{}' has no size; in mm each output needs the size of its picture, "
                            "such as \"698x393\"",
                            place.output));
        for (const OutputPlace& other : places)
            check_pair(other, place);
        places.push_back(place);
    }
    if (places.empty()) throw CanvasFault("no output is named");
    if (places.size() > max_outputs) throw CanvasFault(fmt::format("more than {} outputs", max_outputs));
    return places;
}

}  // namespace

CanvasWords canvas_named(std::string_view text) {
    if (without_blanks(text).empty()) return {};
    try {
        return {.places = places_of(text), .fault = {}};
    } catch (const CanvasFault& fault) {
        return {.places = {}, .fault = fault.what()};
    }
}

}  // namespace vitrine
