#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

namespace vitrine::player {

/// From when on a clock can be right: not earlier than this program was built, nor than a record was written.
/// A record more than ten years younger than the program proves nothing: it was written while the clock was
/// wrong. That a clock is ahead cannot be known.
class EarliestTime {
  public:
    explicit EarliestTime(std::chrono::system_clock::time_point built) : built_(built), time_(built) {}

    void record_written(std::chrono::system_clock::time_point time);

    std::chrono::system_clock::time_point time() const { return time_; }

  private:
    std::chrono::system_clock::time_point built_;
    std::chrono::system_clock::time_point time_;
};

/// The local time, once the clock can be believed.
class Calendar {
  public:
    /// @param catalogue  the records' directory as it is at the start: what is written later may have been
    ///                   written by a clock that is wrong
    explicit Calendar(const std::filesystem::path& catalogue);

    /// None: the clock cannot be right yet. One that systemd-timesyncd has set is.
    std::optional<std::chrono::local_seconds> now() const;

  private:
    EarliestTime earliest_;
};

}  // namespace vitrine::player
