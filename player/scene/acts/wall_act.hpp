#pragma once

#include "base/geometry/box.hpp"
#include "base/settings/choices.hpp"
#include "player/scene/lifted_shots.hpp"
#include "player/scene/pan/pan_course.hpp"
#include "player/scene/transition.hpp"
#include "player/scene/wall_change.hpp"
#include "player/scene/wall_shot.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// An output's part of the canvas of a wall of several boxes.
struct ActPart {
    Box box;         // canvas px; empty: the output was not there yet
    int turned = 0;  // degrees clockwise by which the output hangs turned: 0, 90, 180 or 270

    bool operator==(const ActPart&) const = default;
};

/// The parts that outputs show of one canvas.
struct ActParts {
    Vec2 canvas;                           // px
    std::map<std::string, ActPart> parts;  // by BOX/OUTPUT

    bool operator==(const ActParts&) const = default;
};

/// The words of a wall over several boxes by which everyone knows which act is meant.
struct ActName {
    std::int64_t run = 0;          // of the leader, another number at each of its starts
    std::uint64_t generation = 0;  // counts the acts of a run from 1

    bool operator==(const ActName&) const = default;
};

/// The part of an act of a panning wall: all shots stand still along the wall, and the view moves.
struct ActPan {
    double origin = 0;  // of the places of the shots, ribbon px
    PanCourse course;

    bool operator==(const ActPan&) const = default;
};

/// The words over a whole wall.
struct WallWords {
    CaptionChoice captions = CaptionChoice::none;
    std::string code;   // the text of its own QR code; empty: none
    std::string share;  // where files are dropped, for the idle picture; empty: nothing is told

    bool operator==(const WallWords&) const = default;
};

struct WallAct;

/// The part of an act of the wall of an opened folder: the wall behind it, and the way between both.
struct ActFolder {
    std::shared_ptr<const WallAct> outer;          // the wall behind, without a name
    std::chrono::nanoseconds lag{0};               // from a time of this wall to that of the wall behind
    std::chrono::nanoseconds stands_from = never;  // the clock of the wall behind stands still from then on
    Box mark;                                      // of the way back, px of this wall's canvas
    Box box;                                       // of the folder on the wall behind, canvas px
    bool is_opening = true;
    std::optional<std::chrono::nanoseconds> began;  // of the way; none: this wall is open
    std::chrono::nanoseconds duration{0};           // of the way

    /// The share of the way from the wall behind to this one. @param now  of this wall
    double share(std::chrono::nanoseconds now) const;

    /// The time of the wall behind. @param now  of this wall
    std::chrono::nanoseconds time_behind(std::chrono::nanoseconds now) const {
        return std::min(now + lag, stands_from);
    }
};

/// All that a box needs to draw the same wall as the leader: a value, complete in itself. The leader sends
/// what its own wall draws from, so nothing is computed twice.
///
/// A shot is named by its file in the store, whose name tells path, bytes and time of the medium. All times
/// of shots and of the change are of the leader's wall; `epoch` makes shared time of them.
struct WallAct {
    ActName name;
    std::chrono::nanoseconds epoch{0};     // shared time, since 1970, at which the leader's wall has time 0
    Vec2 canvas;                           // px
    std::map<std::string, ActPart> parts;  // by BOX/OUTPUT; a new output may lie beyond the canvas so far
    CellStyle cells;                       // of the moments on the way
    std::chrono::nanoseconds fade{0};      // time in which a shot of the first wall fades in
    std::vector<PlacedShot> shown;         // the wall before the change; without a change, the wall
    std::optional<WallChange> change;      // none: the wall stands
    std::optional<ActFolder> folder = {};  // none: no folder is open
    std::optional<ActPan> pan = {};        // none: the wall does not pan; one that does has no change
    WallWords words = {};
    bool is_paused = false;  // the wall keeps its shots, and is silent
};

/// The place of an act's canvas on that of another one: each output that both have stays where it is. If they
/// have none in common, the canvas is as large as it fits, in the middle.
Placement place_on(const WallAct& act, const WallAct& other);

/// The wall after the change.
const std::vector<PlacedShot>& last_wall(const WallAct& act);

/// True once nothing of the change and of a way into a folder is left to be seen. @param now  of the leader's
/// wall
bool has_ended(const WallAct& act, std::chrono::nanoseconds now);

/// The frame of an act's wall at any time: before its change, in it, and after it. If it is the wall of an
/// opened folder, nothing is seen of the walls behind.
/// @param now  of the leader's wall
Frame wall_frame(const WallAct& act, std::chrono::nanoseconds now);

/// The frame of an act, of which the wall's frame is a part.
Frame act_frame(const WallAct& act, const Frame& wall, std::chrono::nanoseconds now);

/// The same, of the wall's own frame.
inline Frame act_frame(const WallAct& act, std::chrono::nanoseconds now) {
    return act_frame(act, wall_frame(act, now), now);
}

/// The rooms for captions in the frame of an act, as the leader has them: none while a hand or a way into a
/// folder moves shots, and none on a panning wall.
/// @param bezels  of the act
std::vector<CaptionRoom> captions_of(const WallAct& act, std::span<const Box> bezels,
                                     std::chrono::nanoseconds now);

/// The bezels between the outputs of an act, canvas px.
std::vector<Box> bezels_of(const WallAct& act);

/// True if the output of a box shows a point of the canvas, or hangs nearer to it than those of all others;
/// so exactly one box has each point. A box without an output has each.
/// @param parts  by BOX/OUTPUT
/// @param point  canvas px
bool has_point(const std::string& box, const std::map<std::string, ActPart>& parts, Vec2 point);

/// The act and those of the walls behind.
std::vector<const WallAct*> walls_of(const WallAct& act);

/// The shots of an act's wall by their source, each once. The pointers are valid while the act is unchanged.
std::map<SourceId, const PlacedShot*> shots_of(const WallAct& act);

}  // namespace vitrine::player
