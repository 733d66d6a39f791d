#pragma once

#include "player/layout/layout.hpp"
#include "player/scene/show.hpp"
#include "player/scene/transition.hpp"
#include "player/scene/wall_shot.hpp"
#include "player/scene/wall_sources.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A change of the wall under way. It passes through the phases from top to bottom; each function below is of
/// one phase.
struct WallChange {
    enum class Phase {
        planned,   // its layout is awaited
        wasteful,  // its layout leaves much of the canvas empty: another plan is to be made
        laid_out,  // its sources are to be asked for
        waiting,   // waits for its sources and for the end of the leaving shot's time
        fading,    // from the old wall to the new one
        arriving,  // the first wall: each shot fades in when it is ready
    };

    Phase phase = Phase::planned;
    std::uint64_t generation = 0;  // its plan's generation
    Vec2 canvas;                   // px
    std::vector<PlacedShot> wall;
    std::vector<PlacedShot> calm;  // the wasteful layout, in which shots move little; empty: none
    bool is_final = false;         // the layout: no better one follows
    bool is_by_touch = false;
    std::optional<std::chrono::nanoseconds> pace;  // by touch: duration of its one act; none: the usual
    std::optional<std::chrono::nanoseconds> waiting_since;  // for sources
    std::chrono::nanoseconds began{0};                      // to fade
    std::vector<Act> acts;                                  // its transition's acts

    bool is_fading() const { return phase == Phase::fading || phase == Phase::arriving; }

    /// True if the shots are laid out a second time, without regard to where they stand.
    bool is_replanned() const { return phase == Phase::planned && !calm.empty(); }
};

/// planned: the layout has come, or a better one for the first wall.
void lay_out(WallChange& change, const Layout& layout, const CellStyle& style);

/// laid_out: the shots were laid out anew. Goes back to the calm layout unless that wastes so much more.
/// @param worth  share of the canvas
void choose_layout(WallChange& change, double worth);

/// laid_out: keeps the layout as the calm one; the change is to be planned anew.
void reject_layout(WallChange& change);

/// wasteful: a plan of the same shots without regard to where they stand.
WallPlan plan_anew(WallChange& change, std::uint64_t generation);

/// laid_out: asks for the sources in their sizes.
std::vector<ShotRequest> ask_for_sources(WallChange& change, WallSources& sources,
                                         std::chrono::nanoseconds now);

/// waiting: true if all sources are ready; for the first wall, if one is.
bool is_ready(const WallChange& change, const WallSources& sources, bool is_first);

/// waiting: computes the acts that lead from the shown wall to the new one, if they are not yet, and their
/// duration.
std::chrono::nanoseconds prepare_acts(WallChange& change, std::span<const PlacedShot> shown,
                                      TransitionStyle style);

/// waiting: the new wall begins to fade in; the first wall begins to arrive.
void begin_fade(WallChange& change, std::span<const PlacedShot> shown, std::chrono::nanoseconds now);

/// arriving: shots whose sources are ready appear.
void let_arrive(WallChange& change, const WallSources& sources, std::chrono::nanoseconds now);

/// fading, arriving: true once the new wall stands. A shot that has failed does not arrive.
bool has_ended(const WallChange& change, const WallSources& sources, std::chrono::nanoseconds crossfade,
               std::chrono::nanoseconds now);

/// fading, arriving: the frame at this time.
Frame change_frame(const WallChange& change, const TransitionStyle& style, std::chrono::nanoseconds now);

}  // namespace vitrine::player
