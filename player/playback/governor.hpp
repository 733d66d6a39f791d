#pragma once

#include "player/playback/film_feed.hpp"
#include "player/playback/shot_clock.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The cost and the pictures of one film in the period that is judged.
struct FilmLoad {
    SourceId source = 0;
    double cost = 0;      // cores
    double salience = 0;  // in [0, 1]: its share of the screen
    int due = 0;          // pictures
    int late = 0;         // pictures
};

/// Measures what one film costs and gives, from one judgement to the next.
class FilmMeter {
  public:
    /// The film has another source, whose counts begin at zero.
    void restart() { counts_ = {}; }

    /// The film is seen in the frame of that time; a film that is drawn twice (crossfade) counts with both
    /// areas.
    /// @param share  the part of the screen, in [0, 1]
    void note_shown(double share, std::chrono::nanoseconds time);

    bool was_shown_after(std::chrono::nanoseconds time) const { return shown_ > time; }

    /// The film's load since the last measure().
    /// @param counts  its source's by now
    /// @param passed  time since then
    FilmLoad measure(SourceId source, const ShotCounts& counts, std::chrono::nanoseconds passed);

  private:
    ShotCounts counts_;                   // at the last measure
    std::chrono::nanoseconds shown_{-1};  // time of the last frame that it was in
    double salience_ = 0;                 // its share of the screen in that frame
};

/// Decides which film gives way where the machine is too slow for all: the one that costs most for what is
/// seen of it goes one step down the ladder of `Detail`, one film a period, until nothing is late. After a
/// time without lateness the last one that gave way goes one step up again; where that was too early, the
/// next try waits twice as long, so that a film on the edge does not flicker between two steps.
///
/// Not GStreamer's qos: each of its decoders skips on its own, and fourteen together were measured to show
/// 0.2 pictures a second each instead of 12.
class Governor {
  public:
    struct Change {
        SourceId source = 0;
        Detail detail = Detail::all;
    };

    /// Judges the films that play; to be called once a period, of about a second.
    std::optional<Change> judge(std::span<const FilmLoad> films);

    Detail detail(SourceId source) const;

  private:
    static constexpr int min_patience = 8;  // periods without lateness before a step up

    void forget_all_but(std::span<const FilmLoad> films);
    std::optional<Change> step_down(std::span<const FilmLoad> films);
    std::optional<Change> step_up();

    std::map<SourceId, Detail> details_;  // films that gave way
    std::vector<SourceId> steps_;         // down, the last one at the end
    std::optional<SourceId> tried_;       // stepped up last, on probation
    int settling_ = 0;                    // periods until lateness is due to the last change
    int calm_ = 0;                        // periods without lateness
    int patience_ = min_patience;         // periods of calm before the next step up
};

}  // namespace vitrine::player
