#pragma once

#include "base/state/played_times.hpp"

#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <set>
#include <string>

namespace vitrine::player {

/// Counts for how long each file is seen on each day, in STATE/played/. Time is that of a monotonic clock;
/// only the day is that of the wall's clock, so that a clock that is set loses and doubles nothing. Once a
/// second the counts go into a small file in place, which outlasts a kill; once a minute into the day's file,
/// which also outlasts a power cut. A thread of its own writes, because a disk may take long. Logs.
class PlayLedger {
  public:
    using Duration = std::chrono::nanoseconds;
    using Day = std::optional<std::chrono::local_days>;

    static constexpr Duration max_gap =
        std::chrono::seconds(5);  // a longer one between two looks counts no more

    /// Adds up what a player that was killed has left.
    /// @param folder  STATE/played; made if it is missing
    explicit PlayLedger(std::filesystem::path folder);
    PlayLedger(const PlayLedger&) = delete;
    PlayLedger& operator=(const PlayLedger&) = delete;
    PlayLedger(PlayLedger&&) = delete;
    PlayLedger& operator=(PlayLedger&&) = delete;

    /// Writes all that is counted.
    ~PlayLedger();

    /// Call at every tick. @param seen  paths of the files that are seen from now on
    /// @param now  by a monotonic clock
    /// @param day  today; none: the clock is not plausible
    void look(std::set<std::string> seen, Duration now, const Day& day);

    /// Waits until all that look() has begun to write is written.
    void finish_writing();

  private:
    void recover();
    void remove_old() const;
    void count(Duration elapsed);
    void change_day(std::string name);
    bool is_written();
    void end_writing();
    void write(bool is_day_due);

    struct Counts {
        std::string name;
        PlayedTimes times;
    };

    std::filesystem::path folder_;
    std::set<std::string> seen_;
    std::optional<Duration> last_;  // the time of the last look()
    Counts day_, before_;           // today, and the day before it changed
    std::set<std::string> fresh_;   // paths whose times the day's file does not have yet
    std::set<std::string> handed_;  // those of them that the thread now writes into it
    Duration next_note_{0}, next_day_{0};
    bool has_complained_ = false;
    std::future<bool> written_;  // last: its thread ends before the rest
};

}  // namespace vitrine::player
