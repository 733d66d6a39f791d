#include "player/scene/acts/wall_act.hpp"

#include "player/scene/caption_place.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/folders/opened_frame.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::chrono::duration<double> shortest{1e-9};  // way

bool change_has_ended(const WallAct& act, std::chrono::nanoseconds now) {
    if (!act.change) return true;
    const WallChange& change = *act.change;
    if (change.way) return now - change.began >= change.duration;
    if (change.transition) return now - change.began >= change.transition->duration;
    return std::ranges::all_of(change.wall, [&](const PlacedShot& placed) {
        return placed.began == never || now - placed.began >= act.fade;
    });
}

/// The frame of a panning wall.
Frame pan_frame(const WallAct& act, std::chrono::nanoseconds now) {
    const double view = act.pan->course.at(now) - act.pan->origin;
    std::vector<PlacedShot> seen;
    for (const PlacedShot& placed : act.shown) {
        const Box bounds = bounds_of(*placed.cell);
        if (bounds.max.x > view && bounds.min.x < view + act.canvas.x) seen.push_back(placed);
    }
    return standing_frame(act.canvas, seen, now, {view, 0});
}

}  // namespace

const std::vector<PlacedShot>& last_wall(const WallAct& act) {
    return act.change ? act.change->wall : act.shown;
}

double ActFolder::share(std::chrono::nanoseconds now) const {
    if (!began) return 1;
    const double passed = std::chrono::duration<double>(now - *began) /
                          std::max(std::chrono::duration<double>(duration), shortest);
    return is_opening ? passed : 1 - passed;
}

bool has_ended(const WallAct& act, std::chrono::nanoseconds now) {
    const bool is_on_way = act.folder && act.folder->began && now < *act.folder->began + act.folder->duration;
    return !is_on_way && change_has_ended(act, now);
}

Frame wall_frame(const WallAct& act, std::chrono::nanoseconds now) {
    if (act.pan) return pan_frame(act, now);
    if (change_has_ended(act, now)) return standing_frame(act.canvas, last_wall(act), now);
    return change_frame(*act.change, act.shown, {.duration = act.fade, .cells = act.cells}, now);
}

Frame act_frame(const WallAct& act, const Frame& wall, std::chrono::nanoseconds now) {
    if (!act.folder) return wall;
    const ActFolder& folder = *act.folder;
    const std::chrono::nanoseconds then = folder.time_behind(now);
    const Frame outer = wall_frame(*folder.outer, then);
    const std::optional<ActFolder>& further = folder.outer->folder;
    const Frame outermost = further ? wall_frame(*further->outer, further->time_behind(then)) : Frame{};
    return opened_frame({.top = wall,
                         .outer = outer,
                         .outermost = further ? &outermost : nullptr,
                         .mark = folder.mark,
                         .outer_mark = further ? further->mark : Box{},
                         .box = folder.box,
                         .share = folder.share(now)});
}

Placement place_on(const WallAct& act, const WallAct& other) {
    for (const auto& [name, part] : act.parts) {
        const auto same = other.parts.find(name);
        if (same == other.parts.end() || part.box.is_empty() || same->second.box.is_empty()) continue;
        const double scale = same->second.box.width() / part.box.width();
        return {scale, same->second.box.min - part.box.min * scale};
    }
    return place_on(Canvas(act.canvas), Canvas(other.canvas));
}

std::vector<Box> bezels_of(const WallAct& act) {
    const Box whole{{0, 0}, act.canvas};
    std::vector<Box> outputs;
    for (const auto& [name, part] : act.parts)
        if (!part.box.is_empty() && intersection(part.box, whole) == part.box) outputs.push_back(part.box);
    return canvas_of(act.canvas, std::move(outputs)).bands;
}

std::vector<CaptionRoom> captions_of(const WallAct& act, std::span<const Box> bezels,
                                     std::chrono::nanoseconds now) {
    if (act.pan) return {};
    if (has_ended(act, now)) return caption_rooms(last_wall(act), bezels);
    if (!act.change || act.change->way) return {};
    if (now < act.change->began) return caption_rooms(act.shown, bezels);
    return kept_caption_rooms(act.shown, last_wall(act), bezels);
}

bool has_point(const std::string& box, const std::map<std::string, ActPart>& parts, Vec2 point) {
    const std::string prefix = box + "/";
    const auto away = [&](const Box& part) {
        const Vec2 nearest{std::clamp(point.x, part.min.x, part.max.x),
                           std::clamp(point.y, part.min.y, part.max.y)};
        return length(point - nearest);
    };
    double least = std::numeric_limits<double>::infinity();
    bool is_own = true;  // the nearest one's
    bool has_own = false;
    for (const auto& [name, part] : parts) {
        if (part.box.is_empty()) continue;
        has_own |= name.starts_with(prefix);
        if (away(part.box) >= least) continue;
        least = away(part.box);
        is_own = name.starts_with(prefix);
    }
    return is_own || !has_own;
}

std::vector<const WallAct*> walls_of(const WallAct& act) {
    std::vector<const WallAct*> walls{&act};
    while (walls.back()->folder)
        walls.push_back(walls.back()->folder->outer.get());
    return walls;
}

std::map<SourceId, const PlacedShot*> shots_of(const WallAct& act) {
    std::map<SourceId, const PlacedShot*> shots;
    for (const PlacedShot& placed : last_wall(act))
        shots.emplace(placed.shot.source, &placed);
    for (const PlacedShot& placed : act.shown)
        shots.emplace(placed.shot.source, &placed);
    return shots;
}

}  // namespace vitrine::player
