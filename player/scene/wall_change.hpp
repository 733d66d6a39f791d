#pragma once

#include "player/layout/edit/wall_way.hpp"
#include "player/layout/layout.hpp"
#include "player/scene/show.hpp"
#include "player/scene/transition.hpp"
#include "player/scene/wall_shot.hpp"
#include "player/scene/wall_sources.hpp"
#include "player/scene/wall_touch.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A change of the wall under way. It passes through the phases from top to bottom. The comment of each
/// function below begins with its phase.
struct WallChange {
    enum class Phase {
        planned,   // waits for its layout
        wasteful,  // its layout leaves much of the canvas empty: another plan will be made
        laid_out,  // its sources must be requested
        waiting,   // waits for its sources and for the end of the leaving shot's time
        fading,    // on the way from the old wall to the new one
        arriving,  // the first wall: each shot fades in when its source is ready
    };

    Phase phase = Phase::planned;
    std::uint64_t generation = 0;  // its plan's generation
    Canvas canvas;                 // px
    std::vector<PlacedShot> wall;
    std::vector<PlacedShot> calm;  // the wasteful layout, which moves the shots little; empty: none
    bool is_final = false;         // the layout is final: no better one follows
    bool is_by_touch = false;
    bool is_arranged = false;                               // it gives the shots the places of an arrangement
    std::chrono::nanoseconds duration{0};                   // for a touch
    bool drifts_after = true;                               // for a touch: photos drift on the wall after it
    std::shared_ptr<const WallWay> way;                     // for a touch: since its layout has come
    std::optional<std::chrono::nanoseconds> waiting_since;  // start of waiting for sources
    std::chrono::nanoseconds began{0};                      // start of the transition
    std::optional<Transition> transition;                   // since then; none: the first wall arrives

    bool is_fading() const { return phase == Phase::fading || phase == Phase::arriving; }

    /// True if the shots are laid out a second time, without regard to their present places.
    bool is_replanned() const { return phase == Phase::planned && !calm.empty(); }
};

/// planned: the layout has come, or a better one for the first wall.
void lay_out(WallChange& change, const Layout& layout, const CellStyle& style);

/// laid_out: compares the new layout with the calm one. Returns to the calm layout unless that wastes too
/// much.
/// @param worth  the additional waste that justifies the new layout, as a share of the canvas
void choose_layout(WallChange& change, double worth);

/// laid_out: keeps the layout as the calm one and asks for another plan.
void reject_layout(WallChange& change);

/// wasteful: a plan of the same shots without regard to their present places.
WallPlan plan_anew(WallChange& change, std::uint64_t generation);

/// laid_out: requests the sources in their sizes.
std::vector<ShotRequest> ask_for_sources(WallChange& change, WallSources& sources,
                                         std::chrono::nanoseconds now);

/// waiting: true if all sources are ready; for the first wall, if one is ready.
bool is_ready(const WallChange& change, const WallSources& sources, bool is_first);

/// planned, for a touch: takes the way. @return the wall at its end
TouchedWall take_way(WallChange& change, std::shared_ptr<const WallWay> way);

/// planned, for a touch: starts the way that was taken.
/// @param drifts  photos drift on the new wall; on the way they return from the old wall's drift, or begin it
void begin_way(WallChange& change, std::span<const PlacedShot> shown, bool drifts,
               std::chrono::nanoseconds now);

/// waiting: starts the transition from the shown wall to the new one; the first wall starts to arrive.
/// @param shown  on the change's canvas
void begin_transition(WallChange& change, std::span<const PlacedShot> shown, const TransitionStyle& style,
                      std::chrono::nanoseconds now);

/// arriving: shows the shots whose sources are ready; copies of one shot together.
void let_arrive(WallChange& change, const WallSources& sources, std::chrono::nanoseconds now);

/// fading, arriving: true once the new wall is complete. A failed shot does not arrive.
/// @param arrival  time in which a shot of the first wall fades in
bool has_ended(const WallChange& change, const WallSources& sources, std::chrono::nanoseconds arrival,
               std::chrono::nanoseconds now);

/// fading, arriving: the frame at this time. @param shown  the old wall
Frame change_frame(const WallChange& change, std::span<const PlacedShot> shown, const TransitionStyle& style,
                   std::chrono::nanoseconds now);

}  // namespace vitrine::player
