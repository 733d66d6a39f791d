#pragma once

#include "base/system/unique_fd.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vitrine {

/// A change in a watched directory.
struct DirectoryEvent {
    enum class Kind {
        written,            // a writer closed a file, or a file was moved in
        changed,            // a file's attributes changed
        removed,            // a file was deleted or moved away
        directory_added,    // made or moved in; it may already have files: add() it, then read it
        directory_removed,  // deleted or moved away
        self_gone,          // the watched directory itself was deleted, moved or unmounted
        overflow,           // events were lost: read everything again; directory and name are empty
    };

    Kind kind = Kind::changed;
    std::filesystem::path directory;  // the path given to add()
    std::string name;                 // in that directory, any bytes; empty for self_gone

    bool operator==(const DirectoryEvent&) const = default;
};

/// Reports the changes in directories that the kernel sees (inotify). The kernel does not see the changes of
/// other machines on a network share. Sub-folders are not included: add each folder by itself.
class DirectoryWatch {
  public:
    DirectoryWatch();

    /// Becomes readable when there are events.
    int fd() const { return inotify_.get(); }

    /// Starts to watch a directory. Add it before you read it, so that no change is missed. Adding it again
    /// does no harm.
    /// @param follows_link  the path may be a link to the directory
    /// @return  false, with errno, if it cannot be watched: it is already gone (ENOENT), is no directory
    ///          (ENOTDIR), or too many are watched (ENOSPC: fs.inotify.max_user_watches)
    bool add(const std::filesystem::path& directory, bool follows_link = false);

    /// Forgets the directory and all below it.
    void remove(const std::filesystem::path& directory);

    std::size_t size() const { return by_path_.size(); }

    /// Returns all events so far, in order, without waiting.
    std::vector<DirectoryEvent> read();

  private:
    void forget(int id);

    UniqueFd inotify_;
    std::map<int, std::filesystem::path> by_id_;  // the kernel's number -> directory
    std::map<std::filesystem::path, int> by_path_;
};

}  // namespace vitrine
