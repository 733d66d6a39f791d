#include "player/scene/acts/followed_sources.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr SourceId kept_digits = 1'000'000;  // photo_drift tells photos apart by these
constexpr auto retry_pause = std::chrono::seconds(1);
constexpr auto opening_time = std::chrono::milliseconds(500);  // a film plays by then

template <typename Change> void change_shots(WallAct& act, const Change& change) {
    const auto change_all = [&](std::vector<PlacedShot>& wall) {
        for (PlacedShot& placed : wall)
            change(placed.shot);
    };
    change_all(act.shown);
    if (act.folder) {
        WallAct outer = *act.folder->outer;
        change_shots(outer, change);
        act.folder->outer = std::make_shared<const WallAct>(std::move(outer));
    }
    if (!act.change) return;
    change_all(act.change->wall);
    if (!act.change->transition) return;
    for (auto* const wall : {&act.change->transition->old_wall, &act.change->transition->new_wall})
        for (ChangingShot& shot : *wall)
            change(shot.placed.shot);
}

}  // namespace

SourceId FollowedSources::own_number(std::int64_t run, SourceId source) {
    SourceId& own = own_[{run, source}];
    if (own != 0) return own;
    const SourceId digits = (source % kept_digits + kept_digits - base_ % kept_digits) % kept_digits;
    return own = base_ + digits + kept_digits * ++given_;
}

WallAct FollowedSources::translated(WallAct act) {
    change_shots(act, [&](WallShot& shot) { shot.source = own_number(act.name.run, shot.source); });
    return act;
}

std::optional<SourceId> FollowedSources::find_own(std::int64_t run, SourceId source) const {
    const auto found = own_.find({run, source});
    return found == own_.end() ? std::nullopt : std::optional(found->second);
}

void FollowedSources::set_ready(SourceId source) {
    const auto found = sources_.find(source);
    if (found != sources_.end()) found->second.state = State::ready;
}

void FollowedSources::set_failed(SourceId source, nanoseconds now) {
    const auto found = sources_.find(source);
    if (found == sources_.end()) return;
    found->second.state = State::failed;
    found->second.since = now;
}

std::vector<ShotRequest> FollowedSources::ask_for(const WallAct& act, std::optional<nanoseconds> at,
                                                  nanoseconds now) {
    std::vector<ShotRequest> requests;
    for (const auto& [source, placed] : shots_of(act))
        if (auto request = request_new(*placed, at, now)) requests.push_back(std::move(*request));
    if (!act.folder) return requests;
    const auto behind = at ? std::optional(act.folder->time_behind(*at)) : std::nullopt;
    for (ShotRequest& request : ask_for(*act.folder->outer, behind, now))
        requests.push_back(std::move(request));
    return requests;
}

std::optional<ShotRequest> FollowedSources::ask_for(const FilmMoment& film, nanoseconds at, nanoseconds now) {
    return request_new({.shot = film.shot, .placement = film.placement, .cell = {}, .began = film.began}, at,
                       now);
}

std::optional<ShotRequest> FollowedSources::request_new(const PlacedShot& placed,
                                                        std::optional<nanoseconds> at, nanoseconds now) {
    const SourceId source = placed.shot.source;
    const auto larger = larger_.find(source);
    ShotRequest request = request_of(larger != larger_.end() ? larger->second : placed);
    const auto [place, is_new] = sources_.try_emplace(source, Source{.request = request, .since = now});
    if (!is_new && place->second.request == request) return std::nullopt;
    place->second.request = request;
    if (is_new && at && placed.began < *at) request.at = *at + opening_time - placed.began;
    return request;
}

bool FollowedSources::is_ready(SourceId source) const {
    const auto found = sources_.find(source);
    return found != sources_.end() && found->second.state == State::ready;
}

std::vector<SourceId> FollowedSources::give_up_failed(nanoseconds now) {
    std::vector<SourceId> given_up;
    for (const auto& [source, entry] : sources_)
        if (entry.state == State::failed && now - entry.since >= retry_pause) given_up.push_back(source);
    for (const SourceId source : given_up)
        sources_.erase(source);
    return given_up;
}

bool FollowedSources::are_there(const WallAct& act) const {
    return lacking(act).empty();
}

std::vector<const PlacedShot*> FollowedSources::lacking(const WallAct& act) const {
    std::vector<const PlacedShot*> shots;
    for (const WallAct* const wall : walls_of(act))
        for (const auto& [source, placed] : shots_of(*wall))
            if (!is_ready(source)) shots.push_back(placed);
    return shots;
}

std::vector<SourceId> FollowedSources::retire_all_but(const std::set<SourceId>& kept) {
    std::vector<SourceId> retired;
    for (const auto& [source, entry] : sources_)
        if (!kept.contains(source)) retired.push_back(source);
    for (const SourceId source : retired) {
        sources_.erase(source);
        std::erase_if(own_, [&](const auto& pair) { return pair.second == source; });
    }
    return retired;
}

}  // namespace vitrine::player
