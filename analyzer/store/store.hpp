#pragma once

#include "analyzer/store/surplus.hpp"
#include "base/state/record.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// How much the store may hold.
struct StoreBounds {
    std::uint64_t max_bytes = 0;   // 0: nothing at all
    std::uint64_t least_free = 0;  // bytes that the disk keeps free
    int clip_side = 0;             // px that clips made now would have; 0: never mind
};

/// What the daemon knows of the store: which files are there, which of them the records name. It takes out
/// what nobody names and what goes beyond the bounds; the analysing children put in. Whoever plays a file
/// holds it open, so that taking it out disturbs nothing.
class Store {
  public:
    Store(std::filesystem::path directory, const StoreBounds& bounds);

    bool is_on() const { return bounds_.max_bytes > 0; }

    /// Whether a shot of a ready record is not where it should be, so that an analysis would put it there; or
    /// was made for a screen so much smaller that it would be seen.
    bool lacks(const MediaRecord& record) const;

    /// Whether the sound of a ready film is not where it should be, were it to be heard.
    bool lacks_sound(const MediaRecord& record) const;

    /// Marks in a record what has lost its place; to be called before it is written.
    void mark_dropped(MediaRecord& record) const;

    /// The record names these files from now on, and no others.
    void hold(const MediaRecord& record);

    /// There is no record of this path any more.
    void release(const std::string& path);

    /// A child may be putting files into this folder of the store, or not any more.
    void begin(const std::string& id) { busy_.insert(id); }

    void end(const std::string& id) { busy_.erase(id); }

    /// Whether more is there than may be.
    bool is_over() const { return excess() > 0; }

    /// Takes out what goes beyond the bounds. @return the paths whose records named some of it
    std::set<std::string> make_room();

    /// Looks at all that is there. What no record has named since the last time is taken out.
    void sweep();

  private:
    struct File {
        std::uint64_t bytes = 0;
        std::int64_t used_ns = 0;
    };

    void look_at(const std::string& name);
    void list();
    void take_out(const std::string& name);
    std::uint64_t excess() const;
    std::set<std::string> names() const;
    bool is_busy(const std::string& name) const;

    std::filesystem::path directory_;
    StoreBounds bounds_;
    std::map<std::string, File> files_;                   // what is there, by name
    std::map<std::string, std::set<std::string>> named_;  // path of a record -> files
    std::set<std::string> busy_;                          // folders
    std::set<std::string> unnamed_;                       // at the last sweep
    std::set<std::string> dropped_;                       // in this run
};

}  // namespace vitrine::analyzer
