#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// A folder or file that is shown over everything, at once and for a time.
struct Notice {
    std::string entry;                           // its name in the media folder
    std::optional<std::chrono::seconds> length;  // none: until it is taken away

    bool operator==(const Notice&) const = default;
};

/// The notice that a file belongs to: what lies directly in the media folder and has a name that begins with
/// "!NOW", then perhaps a time, as in "!NOW 20min notice/" and "!NOW 90s.jpg". Seconds, minutes or hours, up
/// to a day. Words are divided by spaces or '_'; upper and lower case are alike.
/// @param path  below the media folder, any bytes
/// @return      none: the file is an ordinary one
std::optional<Notice> notice_named(std::string_view path);

}  // namespace vitrine
