#pragma once

#include "base/settings/choices.hpp"
#include "base/state/record.hpp"
#include "player/scene/files/shot_chooser.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/show_controls.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct SlotSettings {
    int count = 12;
    ShotOrder order = ShotOrder::shuffle;
    std::uint64_t seed = 1;
    FilmShow film = FilmShow::automatic;
    std::chrono::nanoseconds dwell = std::chrono::seconds(20);        // shortest time that a shot stays
    std::chrono::nanoseconds max_dwell = std::chrono::seconds(60);    // limit for whole loops
    std::chrono::nanoseconds spacing = std::chrono::seconds(3);       // between two turns
    std::chrono::nanoseconds lead = std::chrono::seconds(4);          // the next shot is chosen so early
    std::chrono::nanoseconds retry_after = std::chrono::seconds(60);  // time to avoid a file that failed
    SourceId last_source = 0;  // its sources are numbered from here on, apart from those of other walls
    std::shared_ptr<SourceId>
        numbers;  // the last number, shared with other walls; none: `last_source` counts
};

/// The shots on a wall: a fixed number of slots. After its time, the shot in a slot is replaced by the next
/// one in the same place. ShotChooser chooses the next one. Source: Dynamic Media Assemblage, chapter 4 ("we
/// simply substitute the old shot with the new shot in the same position"). Ours: the choice of the slot
/// whose turn it is, one at a time, and a catalogue that changes.
///
/// When a Live Photo or a motion photo comes, its film plays once in the slot, and the photo takes its place.
///
/// If all files fit on the wall, each file is always on it. If a film is alone on the wall, its shots leave
/// one after the other.
class WallSlots {
  public:
    explicit WallSlots(const SlotSettings& settings);

    /// Sets the files. Files that are gone or no longer ready leave at once, a changed file is loaded again
    /// in its slots, and free slots are filled.
    /// @param hints  tell the dwell and the frequency of files
    void set_catalogue(const RecordList& records, const ShowHints& hints = {});

    /// Sets the controls. A turn that is asked for is always taken. A pinned file that is not on the wall
    /// gets the next turn. An arrangement is taken at each call that has one, as soon as there are files.
    void set_controls(const ShowControls& controls);

    /// Replaces at most one shot whose time is nearly over, early enough to prepare the next one. Fills free
    /// slots.
    void advance(std::chrono::nanoseconds now);

    /// The time at which the last replaced shot leaves. None: as soon as possible.
    std::optional<std::chrono::nanoseconds> due() const { return due_; }

    /// Starts the time of this shot.
    void shot_appeared(SourceId source, std::chrono::nanoseconds now);

    /// Avoids the file until it changes or `retry_after` has passed. Its slots go to other files.
    void source_failed(SourceId source, std::chrono::nanoseconds now);

    /// Replaces the shot now. If there is no other shot, avoids its file for `retry_after`.
    void dismiss_shot(SourceId source, std::chrono::nanoseconds now);

    /// Paths of the files that have failed or were dismissed, for as long as they are avoided.
    std::set<std::string> avoided_files() const { return chooser_.avoided_files(); }

    /// The shots to show, in the order of the slots, without free slots.
    std::vector<WallShot> shots() const;

  private:
    struct Slot {
        std::optional<WallShot> shot;
        std::optional<ShotKey> then;  // the photo of a Live Photo, whose film plays once before it
        std::optional<std::chrono::nanoseconds> shown;
        std::chrono::nanoseconds ahead{0};  // it may leave so much earlier
    };

    struct Turn {
        Slot* slot = nullptr;
        std::chrono::nanoseconds due{0};
        std::chrono::nanoseconds loop{0};  // a film's loop if it leaves at the end of one; else 0
    };

    bool is_pinned(const Slot& slot) const;
    const std::string* pinned_and_missing() const;
    void follow_changes(const RecordList& before);
    void fill_slots();
    void fill_arranged();
    void spread_leaving(const std::vector<Slot*>& filled);
    std::vector<Turn> due_turns(std::chrono::nanoseconds until);
    std::optional<ShotKey> choose_shot(const Slot& slot);
    void put_shot(Slot& slot, const ShotKey& key);
    long count_on_wall(const std::string& path) const;

    SlotSettings settings_;
    WallFiles files_;
    ShowHints hints_;
    ShotChooser chooser_;
    std::vector<Slot> slots_;
    std::shared_ptr<SourceId> numbers_;  // the last source's number; shared with other walls
    ShowControls controls_;
    std::uint64_t turns_taken_ = 0;          // number of the requested turns that were taken
    std::chrono::nanoseconds next_turn_{0};  // no turn comes before
    std::optional<std::chrono::nanoseconds> due_;
    std::chrono::nanoseconds last_due_ = std::chrono::nanoseconds::min() / 2;
};

}  // namespace vitrine::player
