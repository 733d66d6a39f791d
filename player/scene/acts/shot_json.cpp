#include "player/scene/acts/shot_json.hpp"

#include "player/scene/acts/cell_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int max_side = 100'000;       // px of a picture
constexpr std::size_t max_path = 4096;  // bytes
constexpr double max_weight = 1e6;
constexpr double region_slack = 1e-3;  // source px by which a region may lie outside its core
constexpr double bend_slack = 1e-6;    // px^2: a corner that is so little concave is one by rounding
constexpr double max_beyond = 8;       // canvases by which the region of a shot may lie outside

std::string text_in(const ActJson& json, const char* key) {
    auto text = json.at(key).get<std::string>();
    if (text.size() > max_path) throw ActFault(fmt::format("an act's '{}' is too long", key));
    return text;
}

ActJson stored_to_json(const StoredShot& stored) {
    return {{"file", stored.file},
            {"begin_ns", stored.begin.count()},
            {"width", stored.width},
            {"height", stored.height}};
}

StoredShot stored_in(const ActJson& json) {
    StoredShot stored{.file = text_in(json, "file"),
                      .begin = time_in(json, "begin_ns"),
                      .width = static_cast<int>(whole_in(json, "width", 1, max_side)),
                      .height = static_cast<int>(whole_in(json, "height", 1, max_side))};
    if (!is_store_name(stored.file)) throw ActFault("an act names a file that is no file of a store");
    if (stored.begin.count() < 0) throw ActFault("a shot of an act begins before its file");
    return stored;
}

/// True for a convex outline that runs counter-clockwise.
bool is_convex(const Polygon& outline) {
    if (outline.size() < 3 || signed_area(outline) <= 0) return false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i];
        const Vec2 b = outline[(i + 1) % outline.size()];
        const Vec2 c = outline[(i + 2) % outline.size()];
        if (cross(b - a, c - b) < -bend_slack) return false;
    }
    return true;
}

void check_item(const WallShot& shot) {
    const LayoutItem& item = shot.item;
    if (!is_convex(item.region)) throw ActFault("the region of a shot of an act is not convex");
    const Box region = bounding_box(item.region);
    const Vec2 slack{region_slack, region_slack};
    const Box core{item.core.min - slack, item.core.max + slack};
    if (core.is_empty() || intersection(region, core) != region)
        throw ActFault("the region of a shot of an act lies outside its picture");
    if (!(shot.picture.x >= 1 && shot.picture.y >= 1 && shot.picture.x <= max_side &&
          shot.picture.y <= max_side && item.weight > 0))
        throw ActFault("a shot of an act has no size");
    if (shot.shot.end < shot.shot.begin || shot.shot.begin.count() < 0)
        throw ActFault("a shot of an act ends before it begins");
    if (shot.kind == MediaKind::film && shot.shot.end == shot.shot.begin)
        throw ActFault("a film of an act has no length");
}

PhotoDrift drift_in(const ActJson& json) {
    const Box ends = box_in(json);
    return {.from = ends.min, .to = ends.max};
}

/// The cells' grid ends at some distance of the canvas.
void check_place(const PlacedShot& placed, Vec2 canvas) {
    const Box region = bounding_box(placed_region(placed.shot.item, placed.placement));
    const Vec2 most = canvas * max_beyond;
    if (region.min.x < -most.x || region.min.y < -most.y || region.max.x > most.x || region.max.y > most.y)
        throw ActFault("an act places a shot far from its canvas");
}

}  // namespace

ActJson shot_to_json(const WallShot& shot) {
    ActJson json{{"source", shot.source},
                 {"slot", shot.slot},
                 {"path", shot.key.path},
                 {"shot", shot.key.shot},
                 {"folder", shot.folder},
                 {"is_film", shot.kind == MediaKind::film},
                 {"picture", to_act_json(shot.picture)},
                 {"active", to_act_json(shot.active)},
                 {"region", to_act_json(shot.item.region)},
                 {"core", to_act_json(shot.item.core)},
                 {"weight", shot.item.weight},
                 {"begin_ns", shot.shot.begin.count()},
                 {"end_ns", shot.shot.end.count()},
                 {"subject", to_act_json(shot.shot.region.drift)}};
    if (shot.shot.stored && !shot.shot.stored->is_dropped) json["stored"] = stored_to_json(*shot.shot.stored);
    return json;
}

WallShot shot_from_json(const ActJson& json) {
    constexpr int most = std::numeric_limits<int>::max();
    WallShot shot{
        .source =
            static_cast<SourceId>(whole_in(json, "source", 0, std::numeric_limits<std::int64_t>::max())),
        .slot = static_cast<int>(whole_in(json, "slot", -1, most)),
        .key = {.path = text_in(json, "path"), .shot = static_cast<int>(whole_in(json, "shot", 0, most))},
        .kind = json.at("is_film").get<bool>() ? MediaKind::film : MediaKind::photo,
        .picture = vec2_in(json.at("picture")),
        .active = box_in(json.at("active")),
        .item = {.region = polygon_in(json.at("region")),
                 .core = box_in(json.at("core")),
                 .weight = number_in(json.at("weight"), max_weight)},
        .shot = {.begin = time_in(json, "begin_ns"), .end = time_in(json, "end_ns")},
        .folder = text_in(json, "folder")};
    shot.shot.region = {.polygon = shot.item.region, .drift = vec2_in(json.at("subject"))};
    if (json.contains("stored")) shot.shot.stored = stored_in(json.at("stored"));
    check_item(shot);
    return shot;
}

ActJson placed_to_json(const PlacedShot& placed, std::size_t shot) {
    ActJson json{{"shot", shot},
                 {"at", to_act_json(placed.placement)},
                 {"group", placed.group},
                 {"drift", to_act_json(Box{placed.drift.from, placed.drift.to})},
                 {"is_above", placed.is_above}};
    if (placed.began != never) json["began_ns"] = placed.began.count();
    if (placed.cell) json["cell"] = cell_to_json(*placed.cell);
    return json;
}

PlacedShot placed_from_json(const ActJson& json, const std::vector<WallShot>& shots, Vec2 canvas) {
    const std::int64_t last = static_cast<std::int64_t>(shots.size()) - 1;
    PlacedShot placed{.shot = shots.at(static_cast<std::size_t>(whole_in(json, "shot", 0, last))),
                      .placement = placement_in(json.at("at")),
                      .cell = {},
                      .began = json.contains("began_ns") ? time_in(json, "began_ns") : never,
                      .group = static_cast<int>(whole_in(json, "group", -1, std::numeric_limits<int>::max())),
                      .drift = drift_in(json.at("drift")),
                      .is_above = json.at("is_above").get<bool>()};
    if (json.contains("cell")) placed.cell = std::make_shared<const Cell>(cell_from_json(json.at("cell")));
    check_place(placed, canvas);
    return placed;
}

}  // namespace vitrine::player
