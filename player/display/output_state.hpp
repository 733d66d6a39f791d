#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The answer of a graphics card to a request.
enum class Outcome {
    nothing,    // none was made
    shown,      // the panel is lit, and shows the picture
    under_way,  // the picture will be shown, and an event will report it
    dropped,    // the card had no time for it: the next picture is newer anyway
    refused,    // not in this mode
    no_master,  // another program has the card
    no_card,    // it was pulled out
};

/// The state machine of an output that is to be lit. The first picture comes with a mode, in a blocking
/// request: some drivers never come back from a non-blocking mode set. All further pictures are page flips,
/// each reported by an event. Whatever goes wrong with one, the next picture comes with the mode again. Knows
/// no card: the caller makes the requests and passes the answers.
class OutputState {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// True if the next picture has to come with the mode.
    bool needs_mode() const { return needs_mode_; }

    /// True while the card has not reported the last flip: no further picture may be given to it.
    bool is_waiting() const { return flip_since_.has_value(); }

    /// @param error  an errno, or 0
    Outcome mode_answered(int error);

    /// @param error  an errno, or 0
    Outcome flip_answered(int error, Time now);

    /// The card has reported a flip. False: none was awaited any more.
    bool flip_arrived();

    /// Gives up after three seconds; to be called every now and then. True: the card never reported the last
    /// flip, and is not waited for any more.
    bool give_up_waiting(Time now);

    /// The panel does not show our picture any more: the next one comes with the mode.
    void start_over();

  private:
    bool needs_mode_ = true;
    std::optional<Time> flip_since_;
    std::optional<Time> busy_since_;  // the begin of the time in which the card refuses flips as busy
};

}  // namespace vitrine::player
