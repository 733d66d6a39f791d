#pragma once

#include "base/settings/settings.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace vitrine {

/// A value in a file or on a command line.
using SettingValue = std::variant<bool, std::int64_t, double, std::string>;

/// Parses a value of a command line: a whole number, a number, true/false or the text itself.
SettingValue setting_value(const std::string& text);

/// Makes settings writable for the functions below, which only return an address; so constant settings can be
/// read with them.
inline Settings& writable(const Settings& settings) {
    return const_cast<Settings&>(settings);
}

// The kinds of settings. Each kind can name the allowed values, assign a value, print the value in the file's
// form, and copy it between two settings. `assign` throws std::invalid_argument for a value that is not
// allowed; the settings then stay unchanged. Its text is a sentence that says what is wrong, or empty.

/// A whole number, an amount of bytes, or a time in whole units of its type.
template <typename T> struct WholeSetting {
    T& (*place)(Settings&);
    std::int64_t min;
    std::int64_t max;
    std::int64_t step;  // between two allowed values, counted from min

    std::string allowed() const;
    void assign(Settings& settings, const SettingValue& value) const;
    std::string text(const Settings& settings) const;

    void copy(const Settings& from, Settings& to) const { place(to) = place(writable(from)); }
};

struct NumberSetting {
    double& (*place)(Settings&);
    double min;
    double max;

    std::string allowed() const;
    void assign(Settings& settings, const SettingValue& value) const;
    std::string text(const Settings& settings) const;

    void copy(const Settings& from, Settings& to) const { place(to) = place(writable(from)); }
};

struct TextSetting {
    std::string& (*place)(Settings&);
    std::string_view allowed_words;
    bool (*is_allowed)(const std::string&);
    std::string (*fault)(const std::string&);  // says what is wrong with a value that is not allowed; or null

    std::string allowed() const { return std::string(allowed_words); }

    void assign(Settings& settings, const SettingValue& value) const;
    std::string text(const Settings& settings) const;

    void copy(const Settings& from, Settings& to) const { place(to) = place(writable(from)); }
};

/// A word of a choice and its value of the enum.
struct ChoiceWord {
    constexpr ChoiceWord() = default;

    template <typename Enum>
    constexpr ChoiceWord(std::string_view text, Enum meaning)
        : word(text), value(static_cast<int>(meaning)) {}

    std::string_view word;  // empty: no word
    int value = 0;
};

using ChoiceWords = std::array<ChoiceWord, 4>;

/// A setting with a few words as values.
struct ChoiceSetting {
    int (*read)(Settings&);
    void (*write)(Settings&, int);
    ChoiceWords words;

    std::string allowed() const;
    void assign(Settings& settings, const SettingValue& value) const;
    std::string text(const Settings& settings) const;

    void copy(const Settings& from, Settings& to) const { write(to, read(writable(from))); }
};

/// true or false.
struct FlagSetting {
    bool& (*place)(Settings&);

    std::string allowed() const { return "true or false"; }

    void assign(Settings& settings, const SettingValue& value) const;
    std::string text(const Settings& settings) const;

    void copy(const Settings& from, Settings& to) const { place(to) = place(writable(from)); }
};

using SettingKind =
    std::variant<WholeSetting<int>, WholeSetting<std::int64_t>, WholeSetting<std::chrono::minutes>,
                 WholeSetting<std::chrono::seconds>, WholeSetting<std::chrono::milliseconds>, NumberSetting,
                 TextSetting, ChoiceSetting, FlagSetting>;

// Makers of kinds for a table of keys: whole<&Settings::layout, &Settings::Layout::slots>(1, 64).

template <auto section, auto field> auto& member_of(Settings& settings) {
    return settings.*section.*field;
}

template <auto section, auto field>
using MemberType = std::remove_reference_t<decltype(std::declval<Settings&>().*section.*field)>;

template <auto section, auto field>
constexpr SettingKind whole(std::int64_t min, std::int64_t max, std::int64_t step = 1) {
    return WholeSetting<MemberType<section, field>>{&member_of<section, field>, min, max, step};
}

template <auto section, auto field> constexpr SettingKind number(double min, double max) {
    return NumberSetting{&member_of<section, field>, min, max};
}

template <auto section, auto field> constexpr SettingKind flag() {
    return FlagSetting{&member_of<section, field>};
}

/// @param allowed  the allowed values in words
/// @param fault    says what is wrong with a value that is not allowed; null: the allowed values say enough
template <auto section, auto field>
constexpr SettingKind text(std::string_view allowed, bool (*is_allowed)(const std::string&),
                           std::string (*fault)(const std::string&) = nullptr) {
    return TextSetting{&member_of<section, field>, allowed, is_allowed, fault};
}

template <auto section, auto field> constexpr SettingKind choice(const ChoiceWords& words) {
    return ChoiceSetting{[](Settings& settings) { return static_cast<int>(settings.*section.*field); },
                         [](Settings& settings, int value) {
                             settings.*section.*field = static_cast<MemberType<section, field>>(value);
                         },
                         words};
}

}  // namespace vitrine
