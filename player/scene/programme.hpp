#pragma once

#include "base/hints/folder_hints.hpp"
#include "base/state/record.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// How files are shown of which something is said, by path.
using ShowHints = std::map<std::string, Hints>;

/// Which files of the catalogue may be shown now, by what their names and folders say. Knows no clock: the
/// time is passed in.
class Programme {
  public:
    void set_records(std::vector<MediaRecord> records);
    void set_folders(FolderHints folders);

    /// @param now   local time; none: it is not known
    /// @return whether other files may be shown than at the last call, or in another way
    bool advance(std::optional<std::chrono::local_seconds> now);

    /// Those that may be shown, in the order of the records.
    std::vector<MediaRecord> open() const;

    const ShowHints& hints() const { return hints_; }

    /// How many files there are, and how many of them may be shown.
    std::size_t count() const { return entries_.size(); }

    std::size_t count_open() const;

    /// Whether any file has a period or hours.
    bool is_scheduled() const { return is_scheduled_; }

  private:
    struct Entry {
        MediaRecord record;
        Hints hints;
        bool is_open = false;
    };

    void read_hints();

    FolderHints folders_;
    std::vector<Entry> entries_;
    ShowHints hints_;
    bool is_scheduled_ = false;
    bool is_new_ = true;  // since the last advance()
};

}  // namespace vitrine::player
