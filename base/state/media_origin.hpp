#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// The source of a time, from the most to the least reliable.
enum class TimeSource {
    camera,        // written by the camera, with its zone
    camera_clock,  // written by the camera without a zone: the zone of this machine is taken
    file,          // the file's own time: that of a copy, for example
};

/// The moment at which a photo or film was taken.
struct TimeTaken {
    std::chrono::sys_time<std::chrono::milliseconds> at;
    std::chrono::minutes zone{0};  // east of UTC, where it was taken
    TimeSource source = TimeSource::file;

    bool operator==(const TimeTaken&) const = default;

    /// The civil time where it was taken.
    std::chrono::local_time<std::chrono::milliseconds> local() const {
        return std::chrono::local_time<std::chrono::milliseconds>(at.time_since_epoch() + zone);
    }
};

/// The facts about a medium that were fixed when it was taken.
struct MediaOrigin {
    std::optional<TimeTaken> taken;  // none: every clock was wrong, or an earlier analysis did not ask
    std::string content_id;          // the same in photo and film of a Live Photo; empty: none
    std::string caption{};           // a line of UTF-8 that somebody wrote into the file; empty: none

    bool operator==(const MediaOrigin&) const = default;

    /// The day on which a camera took it, there. None: a file's own time says nothing about the day.
    std::optional<std::chrono::local_days> day_of_camera() const {
        if (!taken || taken->source == TimeSource::file) return std::nullopt;
        return std::chrono::floor<std::chrono::days>(taken->local());
    }
};

/// The longest pause between two pictures of one moment, such as an afternoon at a lake.
constexpr std::chrono::hours max_moment_pause{2};

/// True from 1990 to a day after `now`. A camera whose battery was empty begins in 1904, 1970 or 1980; a
/// clock a day ahead may be that of another zone.
bool is_plausible(std::chrono::sys_time<std::chrono::milliseconds> taken,
                  std::chrono::system_clock::time_point now);

/// The zone of this machine at that time, minutes east of UTC.
std::chrono::minutes zone_here(std::chrono::system_clock::time_point time);

/// The moment of a civil time in the zone of this machine.
TimeTaken taken_here(std::chrono::local_time<std::chrono::milliseconds> time);

/// True for 1 to 64 letters, digits and '-'.
bool is_content_id(std::string_view text);

}  // namespace vitrine
