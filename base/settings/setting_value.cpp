#include "base/settings/setting_keys.hpp"

#include <charconv>
#include <cmath>

namespace vitrine {

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

}  // namespace vitrine
