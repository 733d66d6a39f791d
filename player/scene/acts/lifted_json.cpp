#include "player/scene/acts/lifted_json.hpp"

#include "player/scene/acts/act_fields.hpp"
#include "player/scene/acts/shot_json.hpp"
#include "player/scene/acts/tapestry_json.hpp"

#include <fmt/format.h>

#include <limits>

namespace vitrine::player {

namespace {

constexpr int version = 1;
constexpr double max_scale = 1e4;
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

double share_in(const ActJson& json, const char* key) {
    const double share = number_in(json.at(key), 1);
    if (share < 0) throw ActFault(fmt::format("the leader tells of lifted shots with a '{}' below 0", key));
    return share;
}

ActJson to_json(const LiftedMoment::Shot& shot) {
    return {{"source", shot.source},           {"state", static_cast<int>(shot.state)},
            {"at", to_act_json(shot.pose.at)}, {"open", shot.pose.open},
            {"alpha", shot.pose.alpha},        {"dims", shot.pose.dims},
            {"full_scale", shot.full_scale},   {"seat", shot.seat}};
}

LiftedMoment::Shot shot_in(const ActJson& json) {
    const auto last_state = static_cast<std::int64_t>(LiftedState::dismissed);
    LiftedMoment::Shot shot{.source = static_cast<SourceId>(whole_in(json, "source", 0, largest)),
                            .state = static_cast<LiftedState>(whole_in(json, "state", 0, last_state)),
                            .pose = {.at = placement_in(json.at("at")),
                                     .open = share_in(json, "open"),
                                     .alpha = share_in(json, "alpha"),
                                     .dims = share_in(json, "dims")},
                            .full_scale = number_in(json.at("full_scale"), max_scale),
                            .seat = share_in(json, "seat")};
    if (shot.full_scale < 0) throw ActFault("the leader tells of a lifted shot with a scale below 0");
    return shot;
}

ActJson to_json(const FilmMoment& film) {
    ActJson json{{"shot", shot_to_json(film.shot)}, {"at", to_act_json(film.placement)}};
    if (film.began != never) json["began_ns"] = film.began.count();
    if (film.ends != never) json["ends_ns"] = film.ends.count();
    return json;
}

FilmMoment film_in(const ActJson& json) {
    const auto time = [&](const char* key) { return json.contains(key) ? time_in(json, key) : never; };
    FilmMoment film{.shot = shot_from_json(json.at("shot")),
                    .placement = placement_in(json.at("at")),
                    .began = time("began_ns"),
                    .ends = time("ends_ns")};
    if (film.began != never && film.ends == never)
        throw ActFault("the leader tells of a photo's film that plays and does not end");
    if (film.shot.kind != MediaKind::film) throw ActFault("the leader tells of a photo's film that is none");
    return film;
}

}  // namespace

std::string lifted_to_json(const ToldHands& told) {
    const LiftedMoment& seen = told.lifted;
    ActJson shots = ActJson::array();
    for (const LiftedMoment::Shot& shot : seen.shots)
        shots.push_back(to_json(shot));
    ActJson json{{"version", version},
                 {"run", told.run},
                 {"shots", std::move(shots)},
                 {"filler_light", seen.filler_light}};
    if (seen.film) json["film"] = to_json(*seen.film);
    if (seen.view) json["view"] = *seen.view;
    if (told.tapestry) json["tapestry"] = tapestry_to_json(*told.tapestry);
    return json.dump();
}

ToldHands lifted_from_json(std::string_view text) {
    try {
        const ActJson json = ActJson::parse(text);
        ToldHands told{.run = whole_in(json, "run", 0, largest)};
        LiftedMoment& seen = told.lifted;
        seen.filler_light = share_in(json, "filler_light");
        for (const ActJson& shot : array_in(json, "shots", max_act_shots))
            seen.shots.push_back(shot_in(shot));
        if (json.contains("film")) seen.film = film_in(json.at("film"));
        if (json.contains("view")) seen.view = number_in(json.at("view"), max_ribbon_length);
        if (json.contains("tapestry")) told.tapestry = tapestry_from_json(json.at("tapestry"));
        return told;
    } catch (const nlohmann::json::exception& error) {
        throw ActFault(fmt::format("the leader tells of lifted shots in words that are not understood: {}",
                                   error.what()));
    }
}

}  // namespace vitrine::player
