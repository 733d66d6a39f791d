#pragma once

#include "base/settings/settings.hpp"
#include "player/layout/plan/planner.hpp"
#include "player/scene/show.hpp"

#include <optional>

namespace vitrine::player {

/// Lays out the plans of a show by the settings: in a thread, or at once if the clock waits for the layout
/// anyway. A layout has the generation of its plan.
class WallPlanner {
  public:
    /// @param settings    outlive this
    /// @param is_at_once  request_layout() returns when the layout is made
    WallPlanner(const Settings& settings, bool is_at_once) : settings_(settings), is_at_once_(is_at_once) {}

    /// Requests a layout. It replaces a plan whose layout is still being made.
    void request_layout(const WallPlan& wall);

    /// Removes and returns the best layout of the newest plan; none: no better one since the last call.
    std::optional<Layout> pop_layout();

  private:
    const Settings& settings_;  // outlive this
    bool is_at_once_;
    std::optional<Layout> made_at_once_;
    Planner planner_;
};

}  // namespace vitrine::player
