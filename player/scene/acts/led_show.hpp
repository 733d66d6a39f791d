#pragma once

#include "player/scene/acts/wall_act.hpp"
#include "player/scene/lifted_shots.hpp"
#include "player/scene/show.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace vitrine::player {

/// The messages that the other boxes must get.
struct LedNews {
    std::optional<WallAct> act;          // the newest; its generation counts the acts
    std::optional<WallAct> preparation;  // the shots that come next; its generation counts the preparations
    LiftedMoment lifted = {};            // what hands do above the wall now
    std::chrono::nanoseconds now{0};     // the show's time
};

/// The facts that the other boxes tell: what they have, and what they lack.
struct LedOthers {
    std::optional<std::uint64_t> ready;  // they have all preparations up to this number; none: nobody is
                                         // waited for
    bool needs_act = false;              // the act under way is wanted once more, with a number of its own
};

/// The show of the box that leads a wall of several boxes. It makes acts of what it shows, from which the
/// others draw the same. Before that it tells which shots come, and waits a while until they have them, too.
class LedShow : public Show {
  public:
    LedShow* led() override { return this; }

    /// Tells which preparations the other boxes have.
    virtual void heed(const LedOthers& others) = 0;

    /// The news since the last call.
    virtual LedNews take_news() = 0;

    /// Sets the parts of the canvas that outputs show, by BOX/OUTPUT.
    virtual void set_parts(std::map<std::string, ActPart> parts) = 0;

    /// True while a change is seen: the wall's clock must not jump.
    virtual bool is_changing() const = 0;
};

}  // namespace vitrine::player
