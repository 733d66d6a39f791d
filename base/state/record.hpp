#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"
#include "base/state/stored_shot.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

enum class MediaKind { photo, film };

/// What the analyzer could say of a file. Only `ready` is ever shown.
enum class MediaState {
    ready,        // shots and regions are known
    waiting,      // incomplete as it is now: a copy under way, an index still missing; tried again
    unsupported,  // whole, but nothing that can be shown
    failed,       // looked like media and could not be read
    quarantined,  // killed its analysing child repeatedly; tried again only when it changes
};

/// How a shot ends; a transition belongs to neither of its shots.
enum class ShotEnd { cut, dissolve, fade, end };

/// The region that must not be covered (paper 1, section 3.3).
struct IRegion {
    Polygon polygon;  // convex, counter-clockwise, px of the upright picture at the shot's begin
    Vec2 drift;       // px per second that the subject moves: at time t the region is polygon + drift * t

    friend bool operator==(const IRegion&, const IRegion&) = default;
};

struct Shot {
    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in stream time; a photo has [0, 0)
    std::chrono::nanoseconds end{0};
    ShotEnd ends_with = ShotEnd::end;
    IRegion region;
    std::optional<StoredShot> stored;  // what is played; nothing: the file itself, or not made yet

    std::chrono::nanoseconds duration() const { return end - begin; }

    friend bool operator==(const Shot&, const Shot&) = default;
};

/// All that is known of one file: the analyzer writes it, the player reads it.
struct MediaRecord {
    static constexpr int current_version = 3;

    std::string path;  // relative to the media root, '/' between folders, any bytes
    MediaKind kind = MediaKind::photo;
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;
    MediaState state = MediaState::waiting;
    bool is_complete = true;  // false: its analysis goes on, shots may be added behind
    std::string reason;       // plain words for the operator; of a ready film, why it is not shown to its end
    int width = 0;            // px of the upright picture, square pixels
    int height = 0;
    std::chrono::nanoseconds duration{0};  // 0 for a photo
    std::vector<Shot> shots;               // in time order, not overlapping; a photo has one
    std::optional<StoredSound> sound;      // of a film that is to be heard; nothing: not kept

    friend bool operator==(const MediaRecord&, const MediaRecord&) = default;
};

/// The part of the picture that every frame of the shot shows once frames are aligned along the drift,
/// in px of the shot's first frame: the intersection over t of Frame - drift * t.
Box core(const MediaRecord& record, const Shot& shot);

/// Whether `after` says of the same content all that `before` says, and at most further shots behind. Where
/// they are stored does not count.
bool is_grown_from(const MediaRecord& after, const MediaRecord& before);

/// The path by which the record of a file names it: relative to the media root where it lies in there, else
/// as it is given.
std::string record_path(const std::filesystem::path& file, const std::filesystem::path& root);

/// Names the file's record: 16 hex digits, the same for the same path.
std::string record_id(const std::string& path);

}  // namespace vitrine
