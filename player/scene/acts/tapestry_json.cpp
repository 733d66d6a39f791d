#include "player/scene/acts/tapestry_json.hpp"

#include <cstdint>
#include <vector>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr std::int64_t longest_film = 10'000'000'000'000'000;  // ns: 115 days
constexpr int max_levels = 64;

nanoseconds film_time_in(const ActJson& json, const char* key) {
    return nanoseconds(whole_in(json, key, 0, longest_film));
}

ActJson to_json(const SeenSpan& seen) {
    return {{"begin_ns", seen.span.begin.count()},
            {"end_ns", seen.span.end.count()},
            {"began_ns", seen.began.count()}};
}

SeenSpan span_in(const ActJson& json) {
    const SeenSpan seen{{film_time_in(json, "begin_ns"), film_time_in(json, "end_ns")},
                        time_in(json, "began_ns")};
    if (seen.span.end <= seen.span.begin)
        throw ActFault("the leader tells of a part of a film that ends before it begins");
    return seen;
}

ActJson to_json(const std::vector<nanoseconds>& moments) {
    ActJson json = ActJson::array();
    for (const nanoseconds moment : moments)
        json.push_back(moment.count());
    return json;
}

std::vector<nanoseconds> film_times_in(const ActJson& json, const char* key) {
    std::vector<nanoseconds> moments;
    for (const ActJson& moment : array_in(json, key, max_moments_of_a_choice))
        moments.emplace_back(whole_of(moment, key, 0, longest_film));
    return moments;
}

TapestryRoom room_in(const ActJson& json) {
    const TapestryRoom room{canvas_in(json.at("canvas")), box_in(json.at("screen"))};
    if (room.screen.is_empty() || intersection(room.screen, {{0, 0}, room.canvas}) != room.screen)
        throw ActFault("the leader tells of a tapestry before a screen that is not on its canvas");
    return room;
}

}  // namespace

ActJson tapestry_to_json(const TapestryMoment& seen) {
    ActJson json{{"path", seen.path},
                 {"folder", seen.folder},
                 {"levels", seen.levels},
                 {"canvas", to_act_json(seen.room.canvas)},
                 {"screen", to_act_json(seen.room.screen)},
                 {"opened_ns", seen.opened.count()},
                 {"centre_ns", seen.view.centre.count()},
                 {"level", seen.view.level},
                 {"width", seen.width},
                 {"touched_ns", seen.touched.time.count()},
                 {"is_lower", seen.touched.is_lower}};
    if (seen.above) json["above"] = to_json(*seen.above);
    if (seen.in_place) json["in_place"] = to_json(*seen.in_place);
    if (seen.looked_for) json["looked_for_ns"] = seen.looked_for->count();
    if (seen.edited)
        json["edited"] = {{"chosen_ns", to_json(seen.edited->keyframes)},
                          {"struck_ns", to_json(seen.edited->struck)}};
    return json;
}

TapestryMoment tapestry_from_json(const ActJson& json) {
    TapestryMoment seen{
        .path = json.at("path").get<std::string>(),
        .folder = json.at("folder").get<std::string>(),
        .levels = static_cast<int>(whole_in(json, "levels", 0, max_levels)),
        .room = room_in(json),
        .opened = time_in(json, "opened_ns"),
        .view = {.centre = film_time_in(json, "centre_ns"), .level = number_in(json.at("level"), max_levels)},
        .width = number_in(json.at("width"), max_ribbon_length),
        .touched = {.time = film_time_in(json, "touched_ns"), .is_lower = json.at("is_lower").get<bool>()}};
    if (json.contains("above")) seen.above = span_in(json.at("above"));
    if (json.contains("in_place")) seen.in_place = span_in(json.at("in_place"));
    if (json.contains("looked_for_ns")) seen.looked_for = film_time_in(json, "looked_for_ns");
    if (json.contains("edited"))
        seen.edited = {.keyframes = film_times_in(json.at("edited"), "chosen_ns"),
                       .struck = film_times_in(json.at("edited"), "struck_ns")};
    if (seen.view.level < 0 || seen.width < 0)
        throw ActFault("the leader tells of a view of a tapestry that is none");
    return seen;
}

}  // namespace vitrine::player
