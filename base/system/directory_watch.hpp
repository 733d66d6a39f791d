#pragma once

#include "base/system/unique_fd.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vitrine {

/// One thing that happened in a watched directory.
struct DirectoryEvent {
    enum class Kind {
        written,            // a file was closed by who wrote it, or moved in
        changed,            // a file's attributes changed
        removed,            // a file was deleted or moved away
        directory_added,    // made or moved in; it may already hold files: add() it, then read it
        directory_removed,  // deleted or moved away
        self_gone,          // the watched directory itself was deleted, moved or unmounted
        overflow,           // events were lost: read everything anew. directory and name are empty
    };

    Kind kind = Kind::changed;
    std::filesystem::path directory;  // as given to add()
    std::string name;                 // in that directory, any bytes; empty for self_gone

    friend bool operator==(const DirectoryEvent&, const DirectoryEvent&) = default;
};

/// Changes in directories as the kernel sees them (inotify). What others do on a network share is not
/// among them, nor what happens below a directory: each is added by itself.
class DirectoryWatch {
  public:
    DirectoryWatch();

    /// Becomes readable when there are events.
    int fd() const { return inotify_.get(); }

    /// Adding before reading the directory leaves no gap; adding again does no harm.
    /// @return false, with errno, where it cannot be watched: it is already gone (ENOENT), is none (ENOTDIR),
    /// or
    ///         too many are (ENOSPC: fs.inotify.max_user_watches)
    bool add(const std::filesystem::path& directory);

    /// Forgets the directory and all below it.
    void remove(const std::filesystem::path& directory);

    std::size_t size() const { return by_path_.size(); }

    /// All events that have come, in order; does not wait.
    std::vector<DirectoryEvent> read();

  private:
    void forget(int id);

    UniqueFd inotify_;
    std::map<int, std::filesystem::path> by_id_;  // the kernel's number -> directory
    std::map<std::filesystem::path, int> by_path_;
};

}  // namespace vitrine
