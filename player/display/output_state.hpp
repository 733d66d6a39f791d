#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// What became of a request to a graphics card.
enum class Outcome {
    nothing,    // none was made
    shown,      // the panel is lit, and shows the picture
    under_way,  // the picture will be shown, and an event tell of it
    dropped,    // the card had no time for it: the next picture is newer anyway
    refused,    // not in this mode
    no_master,  // another program has the card
    no_card,    // it was pulled out
};

/// What follows in the life of an output that is to be lit. The first picture comes with a mode, in a request
/// that is waited for: some drivers never come back from a mode that is set in passing. All further pictures
/// are flips, each told by an event; whatever goes wrong with one, the next picture comes with the mode
/// again. Knows no card: requests are made by who asks it, and their answers told to it.
class OutputState {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Whether the next picture is to come with the mode.
    bool needs_mode() const { return needs_mode_; }

    /// Whether the card still has a picture that it has not told of: no further one is to be given to it.
    bool is_waiting() const { return flip_since_.has_value(); }

    /// @param error  an errno, or 0
    Outcome mode_answered(int error);

    /// @param error  an errno, or 0
    Outcome flip_answered(int error, Time now);

    /// The card has told that the picture is shown. False: none was awaited any more.
    bool flip_arrived();

    /// To be called every now and then. True: the card never told of the last picture, and is not waited for
    /// any more.
    bool give_up_waiting(Time now);

    /// The panel shows nothing of ours any more, or something else.
    void start_over();

  private:
    bool needs_mode_ = true;
    std::optional<Time> flip_since_;
    std::optional<Time> busy_since_;  // flips are refused for want of time
};

}  // namespace vitrine::player
