#include "base/hints/keyframe_choice.hpp"

#include "base/settings/toml_table.hpp"
#include "base/state/name_hash.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vitrine {

namespace {

using std::chrono::nanoseconds;
using Moments = std::vector<nanoseconds>;

constexpr double max_seconds = 1e6;  // of a film
constexpr double minute = 60;        // s
constexpr const char* allowed_moments =
    "a list of moments such as \"0:12\", \"1:02:03.5\" or 34.5 seconds, at most 1000";

std::optional<nanoseconds> of_seconds(double seconds) {
    if (!(seconds >= 0 && seconds <= max_seconds)) return std::nullopt;
    return nanoseconds(std::llround(seconds * 1e9));
}

std::optional<nanoseconds> moment_in(const toml::node& node) {
    if (const auto* text = node.as_string()) return moment_named(text->get());
    if (const auto* whole = node.as_integer()) return of_seconds(static_cast<double>(whole->get()));
    if (const auto* number = node.as_floating_point()) return of_seconds(number->get());
    return std::nullopt;
}

/// The moments of a list, in order and once each; none if one of them is not allowed.
std::optional<Moments> moments_in(const toml::node& node) {
    const auto* list = node.as_array();
    if (list == nullptr || list->size() > max_moments_of_a_choice) return std::nullopt;
    Moments moments;
    for (const toml::node& one : *list) {
        const std::optional<nanoseconds> moment = moment_in(one);
        if (!moment) return std::nullopt;
        moments.push_back(*moment);
    }
    std::ranges::sort(moments);
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    return moments;
}

/// Reads one key into the choice. @return  the fault; empty: none
std::string fault_in_choice(std::string_view key, const toml::node& node, KeyframeChoice& choice) {
    if (key == "only") {
        const auto* flag = node.as_boolean();
        if (flag == nullptr) return "the value of 'only' is not allowed; it must be true or false";
        choice.is_only = flag->get();
        return {};
    }
    if (key != "keyframes" && key != "strike")
        return fmt::format("there is no key '{}'; there are keyframes, strike, only", key);
    std::optional<Moments> moments = moments_in(node);
    if (!moments) return fmt::format("the value of '{}' is not allowed; it must be {}", key, allowed_moments);
    (key == "strike" ? choice.struck : choice.keyframes) = std::move(*moments);
    return {};
}

/// Adds moments while there is room, in order and once each.
void add_moments(const Moments& more, Moments& moments) {
    for (const nanoseconds moment : more) {
        const auto place = std::ranges::lower_bound(moments, moment);
        const bool is_there = place != moments.end() && *place == moment;
        if (!is_there && moments.size() < max_moments_of_a_choice) moments.insert(place, moment);
    }
}

std::string list_of(const Moments& moments) {
    std::string list;
    for (const nanoseconds moment : moments)
        list += fmt::format("{}{}", list.empty() ? "" : ", ", std::chrono::duration<double>(moment).count());
    return list;
}

}  // namespace

std::optional<nanoseconds> moment_named(std::string_view text) {
    double seconds = 0;
    for (int parts = 1;; ++parts) {
        const std::size_t colon = text.find(':');
        const std::string_view part = text.substr(0, colon);
        double value = 0;
        const auto [end, error] =
            std::from_chars(part.data(), part.data() + part.size(), value, std::chars_format::fixed);
        const bool is_whole = part.find_first_not_of("0123456789") == std::string_view::npos;
        const bool is_last = colon == std::string_view::npos;
        if (part.empty() || error != std::errc() || end != part.data() + part.size()) return std::nullopt;
        if ((!is_last && !is_whole) || (parts > 1 && value >= minute) || part.front() == '-')
            return std::nullopt;
        seconds = minute * seconds + value;
        if (is_last) return of_seconds(seconds);
        if (parts == 3) return std::nullopt;
        text.remove_prefix(colon + 1);
    }
}

bool is_struck(const KeyframeChoice& choice, nanoseconds moment) {
    const auto after = std::ranges::lower_bound(choice.struck, moment - strike_reach);
    return after != choice.struck.end() && *after <= moment + strike_reach;
}

KeyframeChoice joined_choice(const KeyframeChoice& file, const KeyframeChoice& touched) {
    KeyframeChoice kept = file;
    std::erase_if(kept.keyframes, [&](nanoseconds moment) { return is_struck(touched, moment); });
    std::erase_if(kept.struck, [&](nanoseconds moment) {
        return std::ranges::any_of(touched.keyframes, [&](nanoseconds chosen) {
            return std::chrono::abs(chosen - moment) <= strike_reach;
        });
    });
    KeyframeChoice joined = touched;
    add_moments(kept.keyframes, joined.keyframes);
    add_moments(kept.struck, joined.struck);
    joined.is_only = file.is_only && !joined.keyframes.empty();
    return joined;
}

KeyframeFile read_keyframe_choice(std::string_view toml, const std::string& source) {
    KeyframeFile file;
    file.faults = faults_in_keys(toml, source, [&](std::string_view key, const toml::node& node) {
        return fault_in_choice(key, node, file.choice);
    });
    if (file.choice.is_only && file.choice.keyframes.empty()) {
        file.faults.push_back(source + ":1: 'only' needs keyframes");
        file.choice.is_only = false;
    }
    return file;
}

std::string to_toml(const KeyframeChoice& choice) {
    std::string text;
    if (!choice.keyframes.empty()) text += fmt::format("keyframes = [{}]\n", list_of(choice.keyframes));
    if (!choice.struck.empty()) text += fmt::format("strike = [{}]\n", list_of(choice.struck));
    if (choice.is_only) text += "only = true\n";
    return text;
}

std::string key_of(const KeyframeChoice& choice) {
    return choice.is_empty() ? "" : name_hash(to_toml(choice));
}

std::string in_words(const KeyframeChoice& choice) {
    const auto count = [](std::size_t moments) {
        return fmt::format("{} keyframe{}", moments, moments == 1 ? "" : "s");
    };
    std::string words;
    if (!choice.keyframes.empty())
        words = fmt::format("{}{} chosen", choice.is_only ? "only " : "", count(choice.keyframes.size()));
    if (choice.struck.empty()) return words;
    if (words.empty()) return count(choice.struck.size()) + " struck";
    return fmt::format("{}, {} struck", words, choice.struck.size());
}

bool is_keyframe_file(std::string_view name) {
    return name.size() > keyframe_file_ending.size() && name.ends_with(keyframe_file_ending);
}

}  // namespace vitrine
