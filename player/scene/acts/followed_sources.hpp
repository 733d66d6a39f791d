#pragma once

#include "player/scene/acts/wall_act.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/touched_film.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The sources of the acts that a box follows. The leader's numbers of sources begin anew at each of its
/// runs, so each gets a number of this box. It has the same last digits, by which photos drift alike.
class FollowedSources {
  public:
    /// @param base  the numbers are greater
    explicit FollowedSources(SourceId base) : base_(base) {}

    /// The act with this box's numbers.
    WallAct translated(WallAct act);

    /// This box's number of a leader's source.
    SourceId own_number(std::int64_t run, SourceId source);

    /// The same. None: nothing has named it.
    std::optional<SourceId> find_own(std::int64_t run, SourceId source) const;

    /// Asks for these shots in the size that they have here, whatever size they have in acts.
    void show_larger(std::map<SourceId, PlacedShot> larger) { larger_ = std::move(larger); }

    void set_ready(SourceId source);
    void set_failed(SourceId source, std::chrono::nanoseconds now);

    /// Requests for the shots of a translated act that are not asked for yet, or were in other sizes.
    /// @param at   the time of the act's leader, to which films that play there are sent; none: none plays
    /// yet
    /// @param now  of this box
    std::vector<ShotRequest> ask_for(const WallAct& act, std::optional<std::chrono::nanoseconds> at,
                                     std::chrono::nanoseconds now);

    /// The same for the film of a photo that was tapped. @param at  the time of the act's leader
    std::optional<ShotRequest> ask_for(const FilmMoment& film, std::chrono::nanoseconds at,
                                       std::chrono::nanoseconds now);

    /// Sources that failed some seconds ago: they are retired, and asked for anew by the next ask_for().
    std::vector<SourceId> give_up_failed(std::chrono::nanoseconds now);

    bool is_ready(SourceId source) const;

    /// True if all shots of a translated act have a picture.
    bool are_there(const WallAct& act) const;

    /// The shots of a translated act that have no picture. Lent as long as the act.
    std::vector<const PlacedShot*> lacking(const WallAct& act) const;

    /// Retires all other sources and returns them. @param kept  of translated acts
    std::vector<SourceId> retire_all_but(const std::set<SourceId>& kept);

  private:
    enum class State { pending, ready, failed };

    struct Source {
        ShotRequest request;
        State state = State::pending;
        std::chrono::nanoseconds since{0};  // of the state
    };

    /// A request, if the shot is not asked for yet, or was in another size.
    std::optional<ShotRequest> request_new(const PlacedShot& placed,
                                           std::optional<std::chrono::nanoseconds> at,
                                           std::chrono::nanoseconds now);

    SourceId base_;
    SourceId given_ = 0;                                         // how many numbers
    std::map<std::pair<std::int64_t, SourceId>, SourceId> own_;  // (run, leader's number) -> own number
    std::map<SourceId, Source> sources_;
    std::map<SourceId, PlacedShot> larger_;
};

}  // namespace vitrine::player
