#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The answer of a graphics card to a request.
enum class Outcome {
    nothing,    // no request was made
    shown,      // the panel is lit, and shows the picture
    under_way,  // the picture will be shown, and an event will report it
    dropped,    // the card had no time for it; the next picture is newer anyway
    refused,    // the card does not accept this mode
    no_master,  // another program has the card
    no_card,    // the card was pulled out
};

/// The state machine of an output that shall be lit. The first picture comes with a mode, in a blocking
/// request: some drivers never return from a non-blocking mode set. All further pictures are page flips, each
/// reported by an event. After any failure the next picture comes with the mode again. Knows no card: the
/// caller makes the requests and passes the answers.
class OutputState {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// True if the next picture must come with the mode.
    bool needs_mode() const { return needs_mode_; }

    /// True while the card has not reported the last flip: do not give it another picture.
    bool is_waiting() const { return flip_since_.has_value(); }

    /// @param error  an errno, or 0
    Outcome mode_answered(int error);

    /// @param error  an errno, or 0
    Outcome flip_answered(int error, Time now);

    /// Call when the card has reported a flip. False: no flip was expected any more.
    bool flip_arrived();

    /// Stops waiting for a flip after three seconds. Call now and then. True: the card never reported the
    /// last flip.
    bool give_up_waiting(Time now);

    /// Call when the panel does not show our picture any more: the next one comes with the mode.
    void start_over();

  private:
    bool needs_mode_ = true;
    std::optional<Time> flip_since_;
    std::optional<Time> busy_since_;  // the start of the time in which the card refuses flips as busy
};

}  // namespace vitrine::player
