#include "base/settings/setting_kind.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace vitrine {

namespace {

[[noreturn]] void refuse(const std::string& fault = {}) {
    throw std::invalid_argument(fault);
}

std::int64_t count_of(std::int64_t value) {
    return value;
}

std::int64_t count_of(std::chrono::milliseconds value) {
    return value.count();
}

std::int64_t count_of(std::chrono::minutes value) {
    return value.count();
}

std::int64_t count_of(std::chrono::seconds value) {
    return value.count();
}

std::string in_quotes(std::string_view text) {
    return fmt::format("\"{}\"", text);
}

/// "0, 90, 180 or 270"
std::string list_of_steps(std::int64_t min, std::int64_t max, std::int64_t step) {
    std::string list = fmt::format("{}", min);
    for (std::int64_t value = min + step; value <= max; value += step)
        list += fmt::format("{}{}", value + step > max ? " or " : ", ", value);
    return list;
}

}  // namespace

SettingValue setting_value(const std::string& text) {
    if (text == "true" || text == "false") return text == "true";
    const char* end = text.data() + text.size();
    std::int64_t whole_value = 0;
    if (const auto [rest, error] = std::from_chars(text.data(), end, whole_value);
        error == std::errc() && rest == end)
        return whole_value;
    double value = 0;
    if (const auto [rest, error] = std::from_chars(text.data(), end, value);
        error == std::errc() && rest == end && std::isfinite(value))
        return value;
    return text;
}

template <typename T> std::string WholeSetting<T>::allowed() const {
    if (step > 1) return list_of_steps(min, max, step);
    return fmt::format("a whole number from {} to {}", min, max);
}

template <typename T> void WholeSetting<T>::assign(Settings& settings, const SettingValue& value) const {
    const auto* given = std::get_if<std::int64_t>(&value);
    if (given == nullptr || *given < min || *given > max || (*given - min) % step != 0) refuse();
    place(settings) = T(*given);
}

template <typename T> std::string WholeSetting<T>::text(const Settings& settings) const {
    return fmt::format("{}", count_of(place(writable(settings))));
}

template struct WholeSetting<int>;
template struct WholeSetting<std::int64_t>;
template struct WholeSetting<std::chrono::minutes>;
template struct WholeSetting<std::chrono::seconds>;
template struct WholeSetting<std::chrono::milliseconds>;

std::string NumberSetting::allowed() const {
    return fmt::format("a number from {} to {}", min, max);
}

void NumberSetting::assign(Settings& settings, const SettingValue& value) const {
    const auto* whole_value = std::get_if<std::int64_t>(&value);
    const auto* given = std::get_if<double>(&value);
    if (whole_value == nullptr && given == nullptr) refuse();
    const double number = given != nullptr ? *given : static_cast<double>(*whole_value);
    if (!(number >= min && number <= max)) refuse();
    place(settings) = number;
}

std::string NumberSetting::text(const Settings& settings) const {
    return fmt::format("{}", place(writable(settings)));
}

void TextSetting::assign(Settings& settings, const SettingValue& value) const {
    const auto* given = std::get_if<std::string>(&value);
    if (given == nullptr) refuse();
    if (!is_allowed(*given)) refuse(fault == nullptr ? std::string() : fault(*given));
    place(settings) = *given;
}

std::string TextSetting::text(const Settings& settings) const {
    return in_quotes(place(writable(settings)));
}

std::string ChoiceSetting::allowed() const {
    std::string list = "one of ";
    for (const ChoiceWord& one : words)
        if (!one.word.empty()) list += (&one == words.data() ? "" : ", ") + in_quotes(one.word);
    return list;
}

void ChoiceSetting::assign(Settings& settings, const SettingValue& value) const {
    const auto* given = std::get_if<std::string>(&value);
    if (given == nullptr || given->empty()) refuse();
    for (const ChoiceWord& one : words)
        if (one.word == *given) return write(settings, one.value);
    refuse();
}

std::string ChoiceSetting::text(const Settings& settings) const {
    const int value = read(writable(settings));
    for (const ChoiceWord& one : words)
        if (!one.word.empty() && one.value == value) return in_quotes(one.word);
    return in_quotes("");
}

void FlagSetting::assign(Settings& settings, const SettingValue& value) const {
    const auto* given = std::get_if<bool>(&value);
    if (given == nullptr) refuse();
    place(settings) = *given;
}

std::string FlagSetting::text(const Settings& settings) const {
    return place(writable(settings)) ? "true" : "false";
}

}  // namespace vitrine
