#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

namespace vitrine::player {

/// The earliest plausible time of the clock: not before this program was built, and not before the newest
/// record was written. A record more than ten years newer than the program proves nothing: it was written
/// while the clock was wrong. A clock that is ahead cannot be detected.
class EarliestTime {
  public:
    explicit EarliestTime(std::chrono::system_clock::time_point built) : built_(built), time_(built) {}

    void record_written(std::chrono::system_clock::time_point time);

    std::chrono::system_clock::time_point time() const { return time_; }

  private:
    std::chrono::system_clock::time_point built_;
    std::chrono::system_clock::time_point time_;
};

/// The local time, once the clock is plausible.
class Calendar {
  public:
    /// @param catalogue  the directory of the records. It is read only once: a later record may have the time
    /// of a wrong clock
    explicit Calendar(const std::filesystem::path& catalogue);

    /// None: the clock is not plausible yet. A clock that is kept right is plausible.
    std::optional<std::chrono::local_seconds> now() const;

  private:
    EarliestTime earliest_;
};

}  // namespace vitrine::player
