#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"
#include "base/state/fault.hpp"
#include "base/state/media_origin.hpp"
#include "base/state/picture_print.hpp"
#include "base/state/shot_look.hpp"
#include "base/state/stored_shot.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

enum class MediaKind { photo, film };

/// The result of the analysis of a file. Only `ready` files are shown.
enum class MediaState {
    ready,        // shots and regions are known
    waiting,      // incomplete, or not the file is at fault: it is tried again
    unsupported,  // complete, but not a file that can be shown
    failed,       // looked like media and could not be read
    quarantined,  // killed its reader or the player repeatedly; it is tried again after a while
};

/// The end of a shot. A transition belongs to neither of its two shots. A split is none: one take goes on.
enum class ShotEnd { cut, dissolve, fade, end, split };

/// The region that must not be covered (paper 1, section 3.3).
struct IRegion {
    Polygon polygon;  // convex, counter-clockwise, px of the upright picture at the shot's start
    Vec2 drift;       // px per second, the subject's movement: at time t the region is polygon + drift * t

    bool operator==(const IRegion&) const = default;
};

/// The content of a stretch of a film outside its shots.
enum class StretchKind {
    transition,  // of two shots
    plain,       // black, white or grey
    empty,       // of a long take, in which nothing stands out
};

/// A stretch of a film that never takes a place on the wall, half-open [begin, end) in stream time.
struct Stretch {
    std::chrono::nanoseconds begin{0};
    std::chrono::nanoseconds end{0};
    StretchKind kind = StretchKind::transition;

    bool operator==(const Stretch&) const = default;
};

struct Shot {
    /// 2: bars are searched, and lines of text. 3: a photo's print, and when a medium was taken. 4: the
    /// caption in a photo. 5: the film in a photo, faces and lines; the network's fine map, of films too. 6:
    /// small faces in films, narrow bars. 7: a subject's closer outline. 8: a thing that looks like a
    /// letter is no line of words. 9: what crosses a film quickly, or grows in it. 10: a network has looked
    /// at every shot. 11: the networks see pictures in their own shape. 12: the plain method's windows have
    /// other weights; a region lets nothing overtake it. A record says nothing of earlier ones.
    static constexpr int current_analysis = 12;
    static constexpr std::size_t max_marks = 100;

    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in stream time; a photo has [0, 0)
    std::chrono::nanoseconds end{0};
    ShotEnd ends_with = ShotEnd::end;
    IRegion region;
    bool is_title = false;              // words on a plain ground; its region holds all of them
    std::optional<double> certainty;    // [0, 1], of the network that knows things; none: it was not asked
    std::optional<ShotLook> look;       // of a picture in its middle; none: an earlier analysis found it
    std::optional<PicturePrint> print;  // of a photo; none: an earlier analysis found it
    std::optional<Box> picture;         // px of the upright picture within its bars; none: it has no bars
    std::vector<Box> marks{};           // of a photo, px of the upright picture: faces and lines of text
    std::optional<StoredShot> stored;   // the file to play; none: the medium itself, or not made yet
    int analysis = current_analysis;    // the version of the analysis that found it

    std::chrono::nanoseconds duration() const { return end - begin; }

    bool operator==(const Shot&) const = default;
};

/// The short film inside the file of a photo, as phones write it. It is played from the store only.
struct InnerFilm {
    Shot shot;      // of the film, whose times are its own
    int width = 0;  // px of its upright pictures, square pixels
    int height = 0;

    bool operator==(const InnerFilm&) const = default;

    /// True: the store has it.
    bool is_there() const { return shot.stored && !shot.stored->is_dropped; }
};

/// The facts about one file. The analyzer writes them, the player reads them.
struct MediaRecord {
    static constexpr int current_version = 3;

    std::string path;  // relative to the media folder, '/' between folders, any bytes
    MediaKind kind = MediaKind::photo;
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;
    std::uint64_t inode = 0;  // 0: not known
    MediaState state = MediaState::waiting;
    bool is_complete = true;  // false: the analysis goes on and may add shots at the end
    std::string reason;  // plain words for the operator; for a ready film, why it is not shown to its end
    Fault fault;         // whose fault it is that the file is not shown
    int width = 0;       // px of the upright picture, square pixels
    int height = 0;
    std::chrono::nanoseconds duration{0};  // 0 for a photo
    std::vector<Shot> shots;               // in time order, not overlapping; a photo has one
    std::optional<InnerFilm> film;         // of a motion photo
    std::vector<Stretch> between;          // all of a film that is no shot, in time order; none: not told
    MediaOrigin origin;                    // when it was taken
    std::optional<StoredSound> sound;      // for a film whose sound may be played; none: it is not stored

    bool operator==(const MediaRecord&) const = default;
};

/// The picture of a shot within its bars, px of the upright picture.
Box active_picture(const MediaRecord& record, const Shot& shot);

/// The smallest box that holds the active pictures of all its shots, px of the upright picture.
Box active_picture(const MediaRecord& record);

/// The part of the active picture that every frame of the shot shows once frames are aligned along the drift,
/// in px of the shot's first frame: the intersection over t of active picture - drift * t.
Box core(const MediaRecord& record, const Shot& shot);

/// True if `after` describes the same content as `before`, with the same shots and perhaps more shots at the
/// end. Ignores the places in the store.
bool is_grown_from(const MediaRecord& after, const MediaRecord& before);

/// True if an earlier version of the analysis found a shot of a ready file: the record holds, and today's
/// analysis would find more.
bool is_outdated(const MediaRecord& record);

/// The path of a file in its record: relative to the media folder if the file is inside, else unchanged.
std::string record_path(const std::filesystem::path& file, const std::filesystem::path& root);

/// The name of the record of a path: its name_hash().
std::string record_id(const std::string& path);

}  // namespace vitrine
