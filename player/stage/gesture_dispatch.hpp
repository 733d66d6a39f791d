#pragma once

#include "player/input/gestures.hpp"
#include "player/stage/show_switch.hpp"
#include "player/stage/stage_files.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace vitrine::player {

/// Passes each gesture of a visitor to the part of the stage that handles it: the tapestry, the opening of a
/// tapestry, or the wall.
class GestureDispatch {
  public:
    /// @param shows, files  outlive this
    GestureDispatch(ShowSwitch& shows, const StageFiles& files) : shows_(shows), files_(files) {}

    void set_canvas(Vec2 canvas) { gestures_.set_rules(gesture_rules(canvas)); }

    /// @param event  canvas px; its time is since the player's start
    void handle_input(const InputEvent& event);

    /// Dispatches the gestures since the last call.
    void dispatch(std::chrono::nanoseconds now);

  private:
    /// A film whose tapestry a visitor wants.
    struct Wish {
        RecordList::Record film;
        std::size_t shot = 0;
        Vec2 at;                                        // canvas px, the place that was touched
        std::optional<std::chrono::nanoseconds> since;  // none: it is new
    };

    Subject subject_of(const InputEvent& event) const;
    bool give_to_tapestry(const Gesture& gesture);
    bool open_tapestry(const Gesture& gesture);
    bool give_to_wall(const Gesture& gesture);
    void open_wanted(std::chrono::nanoseconds now);
    Opening open(const Wish& wish);

    ShowSwitch& shows_;        // outlives this
    const StageFiles& files_;  // outlive this
    Gestures gestures_;
    std::map<std::uint64_t, double> parted_;  // touch -> factor of its pinch so far
    std::optional<Wish> wish_;                // opens as soon as the last change is long enough ago
};

}  // namespace vitrine::player
