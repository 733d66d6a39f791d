#pragma once

#include "player/content/calendar.hpp"
#include "player/content/opening_hours.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace vitrine::player {

/// The days that matter to the files.
struct ShowDays {
    Holidays holidays{};       // count as Sundays
    bool on_this_day = false;  // files taken on this day in other years come first
};

/// Follows the clock and STATE/hints.json, in which the analyzer writes the hints of folders, and tells which
/// files may be shown now. Logs.
class HoursFollower {
  public:
    /// @param state     the state directory
    HoursFollower(const std::filesystem::path& state, const ShowDays& days);

    void set_files(const RecordList& files) { hours_.set_files(files); }

    /// Call about once a second, and after set_files().
    /// @param rehearsed  a local time that replaces the present one
    /// @return  true: other files may be shown than at the last call, or with other hints
    bool look(std::optional<std::chrono::local_seconds> rehearsed);

    /// Removes and returns the paths of the files that look() has found to be open, closed or hinted
    /// otherwise.
    std::set<std::string> take_changed() { return hours_.take_changed(); }

    bool is_open(const std::string& path) const { return hours_.is_open(path); }

    /// False: the clock is not plausible yet.
    bool has_time() const { return has_time_; }

    /// The day whose files of other years come first. None: it does not matter, or the clock is not plausible
    /// yet.
    std::optional<std::chrono::local_days> today() const { return today_; }

    /// "from 20:00 to 21:00"; empty: the file has no times.
    std::string hours_of(const std::string& path) const;

    const ShowHints& hints() const { return hours_.hints(); }

  private:
    void read_folders();
    void log_clock();

    using Version = std::pair<std::filesystem::file_time_type, std::uintmax_t>;  // time of writing, bytes

    std::filesystem::path file_;
    std::optional<Version> read_;  // the version that was read
    OpeningHours hours_;
    Calendar calendar_;
    bool on_this_day_;
    std::optional<std::chrono::local_days> today_;
    bool has_time_ = false;
    std::optional<bool> logged_time_;  // has_time_ in the last log line
};

}  // namespace vitrine::player
