#pragma once

#include "base/hints/hints.hpp"
#include "base/state/record.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Hints by path. A file without hints has no entry.
using ShowHints = std::map<std::string, Hints>;

/// Records that several parts of the player keep at the same time. Copies of the list share the records.
/// Records are large: while a film grows, they would otherwise be copied twice a second during drawing.
class RecordList {
  public:
    using Record =
        std::shared_ptr<const MediaRecord>;  // shared: a show may keep it longer than the catalogue

    RecordList() = default;

    explicit RecordList(std::vector<Record> records) : records_(std::move(records)) {}

    // Implicit, so that a list of plain records can be passed. The records are copied.
    RecordList(std::span<const MediaRecord> records);  // NOLINT

    RecordList(const std::vector<MediaRecord>& records) : RecordList(std::span(records)) {}  // NOLINT

    void add(Record record) { records_.push_back(std::move(record)); }

    auto begin() const { return records_.begin(); }

    auto end() const { return records_.end(); }

    std::size_t size() const { return records_.size(); }

    bool is_empty() const { return records_.empty(); }

    /// The record of a file. None: it is not in the list. @pre the list is ordered by path
    Record find(const std::string& path) const;

    /// The records of the files in a folder of the media folder, including its sub-folders.
    /// @param folder  empty: all records
    RecordList in_folder(const std::string& folder) const;

  private:
    std::vector<Record> records_;
};

}  // namespace vitrine::player
