#pragma once

#include "base/hints/hints.hpp"
#include "base/state/record.hpp"
#include "player/scene/files/shared_list.hpp"

#include <chrono>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A file with hints.
struct HintedFile {
    std::string path;
    Hints hints;

    bool operator==(const HintedFile&) const = default;
};

/// Photos that are one for visitors: frames of a burst, copies, crops and other exposures of one take. At
/// most one of them is on the wall at a time.
struct FileGroup {
    std::vector<std::string> photos;           // paths, the best first
    std::map<std::string, std::string> films;  // of Live Photos: photo -> its film, which has no turn
};

/// A file of a group.
struct GroupedFile {
    std::string path;
    std::shared_ptr<const FileGroup> group;
};

/// Groups by path. A file that is a picture of its own has no entry.
using GroupList = SharedList<GroupedFile>;

/// Hints by path. A file without hints has no entry.
class ShowHints : public SharedList<HintedFile> {
  public:
    GroupList groups;                              // what belongs together
    std::optional<std::chrono::local_days> today;  // files taken on this day in other years come first

    ShowHints() = default;

    ShowHints(std::initializer_list<HintedFile> files);  // NOLINT: implicit, like a map
};

/// Records that several parts of the player keep at the same time.
class RecordList : public SharedList<MediaRecord> {
  public:
    using Record = Entry;  // shared: a show may keep it longer than the catalogue

    RecordList() = default;

    explicit RecordList(std::vector<Record> records) : SharedList(std::move(records)) {}

    // Implicit, so that a list of plain records can be passed. The records are copied.
    RecordList(std::span<const MediaRecord> records);  // NOLINT

    RecordList(const std::vector<MediaRecord>& records) : RecordList(std::span(records)) {}  // NOLINT

    /// The records of the files in a folder of the media folder, including its sub-folders.
    /// @param folder  empty: all records
    RecordList in_folder(const std::string& folder) const;

  private:
    explicit RecordList(SharedList records) : SharedList(std::move(records)) {}
};

}  // namespace vitrine::player
