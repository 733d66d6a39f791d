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

/// The cost and the pictures of one film in one period.
struct FilmLoad {
    SourceId source = 0;
    double cost = 0;      // cores
    double salience = 0;  // its share of the screen, in [0, 1]
    int due = 0;          // pictures
    int late = 0;         // pictures
};

/// Measures the cost and the pictures of one film from one judgement to the next.
class FilmMeter {
  public:
    /// Call when the film has got another source, whose counts start at zero.
    void restart() { counts_ = {}; }

    /// Notes that the film is in the frame of this time. If it is drawn twice (crossfade), both areas count.
    /// @param share  the part of the screen, in [0, 1]
    void note_shown(double share, std::chrono::nanoseconds time);

    bool was_shown_after(std::chrono::nanoseconds time) const { return shown_ > time; }

    /// The film's load since the last call.
    /// @param counts  the present counts of its source
    /// @param passed  time since the last call
    FilmLoad measure(SourceId source, const ShotCounts& counts, std::chrono::nanoseconds passed);

  private:
    ShotCounts counts_;                   // counts at the last measure()
    std::chrono::nanoseconds shown_{-1};  // time of the last frame with this film
    double salience_ = 0;                 // its share of the screen in that frame
};

/// Decides which films show fewer pictures when the machine is too slow for all. Once a period the film with
/// the highest cost for its share of the screen goes one step down in `Detail`, until no picture is late.
/// After a time without lateness the last film that went down goes one step up. If that was too early, the
/// next try waits twice as long, so that a film on the edge does not switch to and fro.
///
/// GStreamer's qos is not used: each decoder skips on its own, and fourteen together were measured to show
/// 0.2 pictures a second each instead of 12.
class Governor {
  public:
    struct Change {
        SourceId source = 0;
        Detail detail = Detail::all;
    };

    /// Judges the films that play. Call once a period of about a second.
    std::optional<Change> judge(std::span<const FilmLoad> films);

    Detail detail(SourceId source) const;

  private:
    static constexpr int min_patience = 8;  // periods without lateness before a step up

    void forget_all_but(std::span<const FilmLoad> films);
    std::optional<Change> step_down(std::span<const FilmLoad> films);
    std::optional<Change> step_up();

    std::map<SourceId, Detail> details_;  // films below Detail::all
    std::vector<SourceId> steps_;         // films that went down, the last one at the end
    std::optional<SourceId> tried_;       // the film that went up last, on probation
    int settling_ = 0;                    // periods until lateness counts again after a change
    int calm_ = 0;                        // periods without lateness
    int patience_ = min_patience;         // periods without lateness before the next step up
};

}  // namespace vitrine::player
