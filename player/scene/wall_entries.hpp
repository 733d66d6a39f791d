#pragma once

#include "player/scene/files/folder_level.hpp"
#include "player/scene/files/group_turns.hpp"
#include "player/scene/wall_slots.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// The shots on a wall whose slots hold files or, if it nests, the entries of one level of the folder tree.
/// The entries take turns as files do (WallSlots): if they all fit on the wall, each is always on it. A
/// folder is shown by several of its shots in one slot (folder_shots). These stay for as long as the folder
/// has its slot; one whose file goes, fails or is dismissed gives way to another.
class WallEntries {
  public:
    /// @param nests  false: the slots hold files, whatever their folders
    WallEntries(const SlotSettings& settings, bool nests);

    /// @param records  the files of the level and below; folders that hold all of them are no level
    void set_catalogue(const RecordList& records, const ShowHints& hints = {});

    /// Sets the controls. A pinned file keeps the entry that it is in on the wall.
    void set_controls(const ShowControls& controls);

    /// The arrangement of the controls until its places have been given; then nullptr.
    const ArrangedWall* arranged() const { return awaited_.get(); }

    /// The shots have got the places of the arrangement.
    void places_given() { awaited_.reset(); }

    void advance(std::chrono::nanoseconds now);

    std::optional<std::chrono::nanoseconds> due() const { return slots_.due(); }

    void shot_appeared(SourceId source, std::chrono::nanoseconds now);
    void source_failed(SourceId source, std::chrono::nanoseconds now);
    void dismiss_shot(SourceId source, std::chrono::nanoseconds now);

    std::set<std::string> avoided_files() const;

    /// The shots to show, in the order of the slots; those of one folder stand together.
    std::vector<WallShot> shots() const;

  private:
    using Time = std::chrono::nanoseconds;

    /// The shots that stand for a folder, while it has its slot.
    using FolderShots = std::vector<WallShot>;

    std::map<SourceId, FolderShots>::iterator folder_with(SourceId source);
    void give_entries();
    void give_controls(const std::shared_ptr<const ArrangedWall>& arranged = {});
    void follow_slots();
    void refresh(const RecordList& before);
    void fill(const WallShot& entry, FolderShots& shots);
    void arrange(const WallShot& entry, FolderShots& shots);
    void avoid(SourceId source, Time now);

    SlotSettings settings_;
    bool nests_;
    WallSlots slots_;
    WallFiles files_;
    GroupTurns groups_;
    ShowHints hints_;
    ShowControls controls_;
    std::shared_ptr<const ArrangedWall> awaited_;          // until its places have been given
    std::map<std::string, RecordList::Record> stand_ins_;  // what the slots know of each folder, by its path
    std::map<SourceId, FolderShots> folders_;              // by the source that the slots have for the folder
    std::map<std::string, Time> avoided_;                  // path -> end of the avoidance
    std::size_t entries_ = 0;                              // of the level
};

}  // namespace vitrine::player
