#pragma once

#include "base/state/record.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The limits of the store.
struct StoreBounds {
    std::uint64_t max_bytes = 0;       // 0: nothing is stored
    std::uint64_t min_free_bytes = 0;  // bytes that the disk keeps free
    int clip_side = 0;                 // px, side of clips made now; 0: the size does not matter
};

/// The store as the daemon knows it: the files in it, and the records that name them. The analysing children
/// put files in; the daemon removes those that no record names and those beyond the bounds. Whoever plays a
/// file holds it open, so that removing it disturbs nothing.
class Store {
  public:
    Store(std::filesystem::path directory, const StoreBounds& bounds);

    bool is_on() const { return bounds_.max_bytes > 0; }

    /// True where a ready record needs an analysis: a shot of it is missing in the store, or was made for a
    /// screen so much smaller that it would be seen.
    bool lacks(const MediaRecord& record) const;

    /// True where a ready film needs an analysis before it can be heard.
    bool lacks_sound(const MediaRecord& record) const;

    /// Marks in a record the files that were removed. Call before the record is written.
    void mark_dropped(MediaRecord& record) const;

    /// The record names these files from now on, and no others.
    void note_record(const MediaRecord& record);

    /// There is no record of this path any more.
    void forget_file(const std::string& path);

    /// A child may be writing into this folder of the store, until end_writing().
    void begin_writing(const std::string& id) { busy_.insert(id); }

    void end_writing(const std::string& id) { busy_.erase(id); }

    /// Removes what goes beyond the bounds.
    /// @return paths of the records that named a removed file
    std::set<std::string> make_room();

    /// Reads the directory anew. Removes the files that no record has named since the sweep before.
    void sweep();

  private:
    struct File {
        std::uint64_t bytes = 0;
        std::int64_t used_ns = 0;
    };

    void measure_file(const std::string& name);
    void read_directory();
    void remove_file(const std::string& name);
    std::uint64_t excess() const;
    std::set<std::string> named_files() const;
    bool is_busy(const std::string& name) const;

    std::filesystem::path directory_;
    StoreBounds bounds_;
    std::map<std::string, File> files_;                   // in the directory, by name
    std::map<std::string, std::set<std::string>> named_;  // path of a record -> files
    std::set<std::string> busy_;                          // folders that a child may be writing into
    std::set<std::string> unnamed_;                       // files without a record at the last sweep
    std::set<std::string> dropped_;                       // files removed in this run
};

}  // namespace vitrine::analyzer
