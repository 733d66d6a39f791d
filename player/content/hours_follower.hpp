#pragma once

#include "player/content/calendar.hpp"
#include "player/content/opening_hours.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Follows what the analyzer says of the folders (STATE/hints.json) and the clock: which files may be shown
/// now. Logs.
class HoursFollower {
  public:
    explicit HoursFollower(const std::filesystem::path& state);

    void set_files(RecordList files) {
        files_ = std::move(files);
        hours_.set_files(files_);
    }

    /// To be called about once a second, and after new records.
    /// @param rehearsed  the local time to be taken for the present one
    /// @return whether other files may be shown than at the last call, or in another way
    bool look(std::optional<std::chrono::local_seconds> rehearsed);

    /// The files that may be shown now.
    RecordList open() const;

    const ShowHints& hints() const { return hours_.hints(); }

  private:
    void read_folders();
    void tell(bool has_time);

    std::filesystem::path file_;
    std::optional<std::pair<std::filesystem::file_time_type, std::uintmax_t>>
        read_;  // the file as it was read
    RecordList files_;
    OpeningHours hours_;
    Calendar calendar_;
    std::optional<bool> told_time_;       // whether the time was known, as last told
    std::size_t told_closed_ = SIZE_MAX;  // files that may not be shown, as last told
};

}  // namespace vitrine::player
