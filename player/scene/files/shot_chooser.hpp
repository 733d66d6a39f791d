#pragma once

#include "base/settings/choices.hpp"
#include "player/scene/files/group_turns.hpp"
#include "player/scene/files/shot_rotation.hpp"
#include "player/scene/files/show_files.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// The files that a wall may show: those whose shots can all be shown.
class WallFiles {
  public:
    /// Takes over what has changed since the last call.
    void set(const RecordList& records);

    const RecordList& all() const { return shown_; }

  private:
    RecordList given_;
    RecordList shown_;
};

/// The slot that needs another shot, and the wall around it.
struct FreeSlot {
    std::vector<ShotKey> on_wall;         // all shots on the wall, including the leaving one
    std::string leaving;                  // path of the file that leaves the slot; empty: the slot is free
    std::size_t slots = 0;                // the wall's number of slots
    const std::string* pinned = nullptr;  // a file that shall come first; lent for the call
};

/// Says if the shots of a film follow each other in time.
/// @param files  the number of files that the wall may show
bool is_in_sequence(FilmShow film, std::size_t files);

/// Chooses the next shot for a slot, from a rotation of all shots.
///
/// Every shot is shown once before any repeats, new files first. No shot is on the wall twice. Exception: a
/// file that has a single place may repeat there. As long as shots of other files wait, a file is on the wall
/// once. A film alone fills all slots with its shots in time order. Files that are one (FileGroup) take turns
/// as one file: never two of them are on the wall, unless one is pinned.
class ShotChooser {
  public:
    ShotChooser(ShotOrder order, std::uint64_t seed, FilmShow film) : rotation_(order, seed), film_(film) {}

    /// @param before  the previous files; one that has changed since is not avoided any more
    /// @param hints   tell the frequency of files
    void set_files(const RecordList& files, const RecordList& before, const ShowHints& hints);

    /// Chooses no shot of the file until this time, unless the file changes.
    void avoid_file(const std::string& path, std::chrono::nanoseconds until) { avoided_[path] = until; }

    bool is_avoided(const std::string& path) const { return avoided_.contains(path); }

    std::set<std::string> avoided_files() const;

    /// @return true: a file may be chosen again from now on
    bool end_avoidance(std::chrono::nanoseconds now);

    std::optional<ShotKey> next_shot(const FreeSlot& slot);

    /// The groups of the files.
    const GroupTurns& groups() const { return groups_; }

  private:
    FreeSlot by_heads(const FreeSlot& slot) const;
    std::optional<ShotKey> next_head(const FreeSlot& slot);
    std::optional<ShotKey> next_shot_of(const std::string& path, const FreeSlot& slot);

    ShotRotation rotation_;  // of one file a group
    FilmShow film_;
    GroupTurns groups_;
    std::size_t files_ = 0;                                    // number of files that take turns
    std::map<std::string, std::chrono::nanoseconds> avoided_;  // path -> end of the avoidance
};

}  // namespace vitrine::player
