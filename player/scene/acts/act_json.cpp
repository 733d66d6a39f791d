#include "player/scene/acts/act_json.hpp"

#include "player/scene/acts/act_fields.hpp"
#include "player/scene/acts/cell_json.hpp"
#include "player/scene/acts/shot_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr int version = 1;
constexpr double max_cell_length = 1000;  // px, of a gutter, a radius or a feather
constexpr double max_pan_speed = 1e5;     // px a second
constexpr std::size_t max_parts = 64;
constexpr std::size_t max_words = 1000;  // bytes of a code, or of an address
constexpr int max_folders = 2;           // open behind one another, of which something is seen
constexpr auto max_change_time = 60s;
constexpr std::chrono::nanoseconds max_lag = 24h * 3650;  // sums of times stay in range

/// The shots of an act with their numbers.
class ShotNumbers {
  public:
    ActJson placed(const std::vector<PlacedShot>& wall) {
        ActJson all = ActJson::array();
        for (const PlacedShot& one : wall)
            all.push_back(placed_to_json(one, number_of(one.shot)));
        return all;
    }

    ActJson json = ActJson::array();

  private:
    std::size_t number_of(const WallShot& shot) {
        const auto [place, is_new] = numbers_.try_emplace(shot.source, numbers_.size());
        if (is_new) json.push_back(shot_to_json(shot));
        return place->second;
    }

    std::map<SourceId, std::size_t> numbers_;
};

ActJson style_to_json(const CellStyle& style) {
    return {{"is_taut", style.is_taut}, {"gutter", style.gutter},          {"radius", style.corner_radius},
            {"feather", style.feather}, {"spacing", style.sample_spacing}, {"inset", style.sample_inset}};
}

CellStyle style_in(const ActJson& json) {
    CellStyle style{.is_taut = json.at("is_taut").get<bool>(),
                    .gutter = number_in(json.at("gutter"), max_cell_length),
                    .corner_radius = number_in(json.at("radius"), max_cell_length),
                    .feather = number_in(json.at("feather"), max_cell_length),
                    .sample_spacing = number_in(json.at("spacing"), max_cell_length),
                    .sample_inset = number_in(json.at("inset"), max_cell_length)};
    const bool is_sampled_too_finely = style.sample_spacing > 0 && style.sample_spacing < 0.5;
    if (style.gutter < 0 || style.corner_radius < 0 || style.feather < 0 || style.sample_spacing < 0 ||
        style.sample_inset < 0 || is_sampled_too_finely)
        throw ActFault("an act has cells of a style that cannot be made");
    return style;
}

ActJson changing_to_json(const std::vector<ChangingShot>& wall) {
    ActJson all = ActJson::array();
    for (const ChangingShot& shot : wall) {
        ActJson json{{"focus", to_act_json(shot.focus)}};
        if (shot.moving) json["moving"] = *shot.moving;
        all.push_back(std::move(json));
    }
    return all;
}

ActJson placements_to_json(const std::vector<Placement>& placements) {
    ActJson all = ActJson::array();
    for (const Placement& placement : placements)
        all.push_back(to_act_json(placement));
    return all;
}

ActJson transition_to_json(const Transition& transition) {
    ActJson keys = ActJson::array();
    for (const std::vector<Placement>& key : transition.motion.keys)
        keys.push_back(placements_to_json(key));
    return {{"old", changing_to_json(transition.old_wall)},
            {"new", changing_to_json(transition.new_wall)},
            {"kind", static_cast<int>(transition.motion.kind)},
            {"keys", std::move(keys)},
            {"fade", ActJson::array({transition.fade_begin, transition.fade_end})},
            {"duration_ns", transition.duration.count()}};
}

/// @param shots  how many entries belong there
std::vector<Placement> placements_in(const ActJson& json, std::size_t shots) {
    if (!json.is_array() || json.size() != shots)
        throw ActFault("an act has not one place for each shot that moves");
    std::vector<Placement> placements;
    for (const ActJson& one : json)
        placements.push_back(placement_in(one));
    return placements;
}

Motion motion_in(const ActJson& json) {
    const ActJson& keys = array_in(json, "keys", max_act_keys);
    Motion motion{.kind = static_cast<Motion::Kind>(whole_in(json, "kind", 0, 4)), .keys = {}};
    if (keys.empty() || !keys.front().is_array() || keys.front().size() > max_act_shots)
        throw ActFault("an act has a motion without places");
    const bool has_stages = motion.kind == Motion::Kind::still || keys.size() > 1;
    if (!has_stages) throw ActFault("an act has a motion with one moment only");
    for (const ActJson& key : keys)
        motion.keys.push_back(placements_in(key, keys.front().size()));
    return motion;
}

std::vector<ChangingShot> changing_in(const ActJson& json, const char* key,
                                      const std::vector<PlacedShot>& wall, std::size_t moving) {
    const ActJson& all = array_in(json, key, max_act_shots);
    if (all.size() != wall.size()) throw ActFault("an act does not tell of each shot how it changes");
    std::vector<ChangingShot> shots;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        ChangingShot& shot = shots.emplace_back(
            ChangingShot{.placed = wall[i], .moving = {}, .focus = vec2_in(all[i].at("focus"))});
        if (moving == 0 && all[i].contains("moving")) throw ActFault("an act moves a shot that has no way");
        if (all[i].contains("moving"))
            shot.moving = static_cast<std::size_t>(
                whole_in(all[i], "moving", 0, static_cast<std::int64_t>(moving) - 1));
    }
    return shots;
}

/// @param act  with the walls before and after the change
Transition transition_in(const ActJson& json, const WallAct& act) {
    Transition transition{.canvas = act.canvas, .old_wall = {}, .new_wall = {}, .motion = motion_in(json)};
    const std::size_t moving = transition.motion.keys.front().size();
    transition.old_wall = changing_in(json, "old", act.shown, moving);
    transition.new_wall = changing_in(json, "new", act.change->wall, moving);
    const ActJson& fade = array_in(json, "fade", 2);
    transition.fade_begin = number_in(fade.at(0), 1);
    transition.fade_end = number_in(fade.at(1), 1);
    if (transition.fade_begin < 0 || transition.fade_end <= transition.fade_begin)
        throw ActFault("an act has a change that fades in no time");
    transition.duration = time_in(json, "duration_ns");
    if (transition.duration < 0ns || transition.duration > max_change_time)
        throw ActFault("an act has a change that ends before it begins, or takes too long");
    return transition;
}

ActJson way_to_json(const WallWay& way) {
    ActJson keys = ActJson::array();
    for (const WallKey& key : way.keys) {
        ActJson cells = ActJson::array();
        for (const auto& cell : key.cells)
            cells.push_back(cell_to_json(*cell));
        keys.push_back({{"at", placements_to_json(key.placements)},
                        {"cells", std::move(cells)},
                        {"alphas", key.alphas}});
    }
    return keys;
}

/// @param shots  on the wall
WallWay way_in(const ActJson& json, std::size_t shots) {
    WallWay way;
    for (const ActJson& key : array_in(json, "way", max_act_keys)) {
        WallKey& made = way.keys.emplace_back(
            WallKey{.placements = placements_in(key.at("at"), shots), .cells = {}, .alphas = {}});
        for (const ActJson& cell : array_in(key, "cells", max_act_shots))
            made.cells.push_back(std::make_shared<const Cell>(cell_from_json(cell)));
        for (const ActJson& alpha : array_in(key, "alphas", max_act_shots)) {
            made.alphas.push_back(number_in(alpha, 1));
            if (made.alphas.back() < 0) throw ActFault("an act has a shot that is less than not there");
        }
        if (made.cells.size() != shots || made.alphas.size() != shots)
            throw ActFault("an act has a moment on a way without all its shots");
    }
    if (way.keys.empty()) throw ActFault("an act has a way without moments");
    return way;
}

ActJson change_to_json(const WallChange& change, ShotNumbers& shots) {
    ActJson json{{"wall", shots.placed(change.wall)}, {"began_ns", change.began.count()}};
    if (change.transition) json["transition"] = transition_to_json(*change.transition);
    if (!change.way) return json;
    json["way"] = way_to_json(*change.way);
    json["duration_ns"] = change.duration.count();
    return json;
}

std::vector<PlacedShot> wall_in(const ActJson& json, const char* key, const std::vector<WallShot>& shots,
                                Vec2 canvas) {
    std::vector<PlacedShot> wall;
    for (const ActJson& placed : array_in(json, key, max_act_shots)) {
        wall.push_back(placed_from_json(placed, shots, canvas));
        for (std::size_t i = 0; i + 1 < wall.size(); ++i)
            if (wall[i].shot.source == wall.back().shot.source)
                throw ActFault("an act has a shot twice on one wall");
    }
    return wall;
}

/// @param act  with the wall before the change
WallChange change_in(const ActJson& json, const std::vector<WallShot>& shots, const WallAct& act) {
    WallChange change{.phase = WallChange::Phase::fading,
                      .canvas = act.canvas,
                      .wall = wall_in(json, "wall", shots, act.canvas),
                      .is_final = true,
                      .began = time_in(json, "began_ns")};
    if (!json.contains("way")) return change;
    if (act.shown.size() != change.wall.size())
        throw ActFault("an act has a way on which shots come or leave");
    change.way = std::make_shared<const WallWay>(way_in(json, change.wall.size()));
    change.duration = time_in(json, "duration_ns");
    if (change.duration <= 0ns || change.duration > max_change_time)
        throw ActFault("an act has a way that takes no time, or too long");
    return change;
}

void check_cells(const std::vector<PlacedShot>& wall) {
    if (std::ranges::any_of(wall, [](const PlacedShot& placed) { return placed.cell == nullptr; }))
        throw ActFault("an act has a shot without a cell");
}

void take_change(WallAct& act, const ActJson& json, const std::vector<WallShot>& shots) {
    act.change = change_in(json, shots, act);
    check_cells(act.change->wall);
    if (act.change->way) return;
    if (json.contains("transition"))
        act.change->transition = transition_in(json.at("transition"), act);
    else if (act.shown.empty())
        act.change->phase = WallChange::Phase::arriving;
    else
        throw ActFault("an act has a change and does not say how");
}

ActJson parts_to_json(const std::map<std::string, ActPart>& parts) {
    ActJson json = ActJson::object();
    for (const auto& [name, part] : parts)
        json[name] = {{"box", to_act_json(part.box)}, {"turned", part.turned}};
    return json;
}

std::map<std::string, ActPart> parts_in(const ActJson& json) {
    std::map<std::string, ActPart> parts;
    if (!json.is_object() || json.size() > max_parts) throw ActFault("an act has too many outputs, or none");
    for (const auto& [name, part] : json.items()) {
        ActPart& made = parts[name];
        made = {.box = box_in(part.at("box")), .turned = static_cast<int>(whole_in(part, "turned", 0, 270))};
        if (made.turned % 90 != 0) throw ActFault("an output of an act hangs neither upright nor on a side");
    }
    return parts;
}

ActJson pan_to_json(const ActPan& pan) {
    return {{"origin", pan.origin},
            {"view", pan.course.view},
            {"since_ns", pan.course.since.count()},
            {"speed", pan.course.speed},
            {"last", pan.course.last}};
}

ActPan pan_in(const ActJson& json) {
    return {.origin = number_in(json.at("origin"), max_ribbon_length),
            .course = {.view = number_in(json.at("view"), max_ribbon_length),
                       .since = time_in(json, "since_ns"),
                       .speed = number_in(json.at("speed"), max_pan_speed),
                       .last = number_in(json.at("last"), max_ribbon_length)}};
}

ActJson words_to_json(const WallWords& words) {
    return {{"captions", static_cast<int>(words.captions)}, {"code", words.code}, {"share", words.share}};
}

WallWords words_in(const ActJson& json) {
    constexpr auto last = static_cast<std::int64_t>(CaptionChoice::names);
    WallWords words{.captions = static_cast<CaptionChoice>(whole_in(json, "captions", 0, last)),
                    .code = json.at("code").get<std::string>(),
                    .share = json.at("share").get<std::string>()};
    if (std::max(words.code.size(), words.share.size()) > max_words)
        throw ActFault("an act has words that are too long");
    return words;
}

ActJson act_to_json(const WallAct& act);
WallAct act_in(const ActJson& json, int folders);

ActJson folder_to_json(const ActFolder& folder) {
    ActJson json{{"outer", act_to_json(*folder.outer)}, {"lag_ns", folder.lag.count()},
                 {"mark", to_act_json(folder.mark)},    {"box", to_act_json(folder.box)},
                 {"is_opening", folder.is_opening},     {"duration_ns", folder.duration.count()}};
    if (folder.stands_from != never) json["stands_from_ns"] = folder.stands_from.count();
    if (folder.began) json["began_ns"] = folder.began->count();
    return json;
}

/// @param folders  how many more may lie behind one another
ActFolder folder_in(const ActJson& json, int folders) {
    if (folders == 0) throw ActFault("an act has more folders behind one another than are ever seen");
    ActFolder folder{.outer = std::make_shared<const WallAct>(act_in(json.at("outer"), folders - 1)),
                     .lag = time_in(json, "lag_ns"),
                     .mark = box_in(json.at("mark")),
                     .box = box_in(json.at("box")),
                     .is_opening = json.at("is_opening").get<bool>(),
                     .duration = time_in(json, "duration_ns")};
    if (json.contains("stands_from_ns")) folder.stands_from = time_in(json, "stands_from_ns");
    if (json.contains("began_ns")) folder.began = time_in(json, "began_ns");
    const bool has_boxes = folder.mark.width() >= 1 && folder.mark.height() >= 1 && folder.box.width() >= 1 &&
                           folder.box.height() >= 1;
    if (!has_boxes) throw ActFault("an act has a folder without a place");
    if (folder.duration < 0ns || folder.duration > max_change_time)
        throw ActFault("an act has a way into a folder that takes too long");
    if (std::chrono::abs(folder.lag) > max_lag)
        throw ActFault("an act has a wall behind a folder whose clock is years away");
    if (folder.outer->pan) throw ActFault("an act has a folder on a wall that pans");
    return folder;
}

ActJson act_to_json(const WallAct& act) {
    ShotNumbers shots;
    ActJson json{{"version", version},
                 {"run", act.name.run},
                 {"generation", act.name.generation},
                 {"epoch_ns", act.epoch.count()},
                 {"canvas", to_act_json(act.canvas)},
                 {"parts", parts_to_json(act.parts)},
                 {"cells", style_to_json(act.cells)},
                 {"fade_ns", act.fade.count()},
                 {"shown", shots.placed(act.shown)}};
    if (act.change) json["change"] = change_to_json(*act.change, shots);
    if (act.folder) json["folder"] = folder_to_json(*act.folder);
    if (act.pan) json["pan"] = pan_to_json(*act.pan);
    if (act.words != WallWords{}) json["words"] = words_to_json(act.words);
    if (act.is_paused) json["paused"] = true;
    json["shots"] = std::move(shots.json);
    return json;
}

WallAct act_in(const ActJson& json, int folders) {
    if (whole_in(json, "version", 0, std::numeric_limits<std::int64_t>::max()) != version)
        throw ActFault("the leader of the wall sends acts of another version; both need the same Vitrine");
    WallAct act{.name = {.run = whole_in(json, "run", 0, std::numeric_limits<std::int64_t>::max()),
                         .generation = static_cast<std::uint64_t>(
                             whole_in(json, "generation", 0, std::numeric_limits<std::int64_t>::max()))},
                .epoch = time_in(json, "epoch_ns"),
                .canvas = canvas_in(json.at("canvas")),
                .parts = parts_in(json.at("parts")),
                .cells = style_in(json.at("cells")),
                .fade = time_in(json, "fade_ns"),
                .shown = {},
                .change = {}};
    if (act.fade < 0ns || act.fade > max_change_time)
        throw ActFault("an act has a wall that fades in too long");
    std::vector<WallShot> shots;
    for (const ActJson& shot : array_in(json, "shots", 2 * max_act_shots))
        shots.push_back(shot_from_json(shot));
    act.shown = wall_in(json, "shown", shots, act.canvas);
    check_cells(act.shown);
    if (json.contains("change")) take_change(act, json.at("change"), shots);
    if (json.contains("folder")) act.folder = folder_in(json.at("folder"), folders);
    if (json.contains("words")) act.words = words_in(json.at("words"));
    act.is_paused = json.value("paused", false);
    if (!json.contains("pan")) return act;
    if (act.change || act.folder) throw ActFault("an act has a panning wall that changes, or a folder on it");
    act.pan = pan_in(json.at("pan"));
    return act;
}

}  // namespace

std::string to_json(const WallAct& act) {
    // a path may hold any bytes; what is no UTF-8 in it is for the log only
    return act_to_json(act).dump(-1, ' ', false, ActJson::error_handler_t::replace);
}

WallAct act_from_json(std::string_view text) {
    if (text.size() > max_act_bytes) throw ActFault("an act is larger than 1 MiB");
    try {
        return act_in(ActJson::parse(text), max_folders);
    } catch (const nlohmann::json::exception& error) {
        throw ActFault(fmt::format("a text is no act: {}", error.what()));
    }
}

}  // namespace vitrine::player
