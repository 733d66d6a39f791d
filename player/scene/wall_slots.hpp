#pragma once

#include "base/settings/choices.hpp"
#include "base/state/record.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_rotation.hpp"
#include "player/scene/show_controls.hpp"
#include "player/scene/show_files.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct SlotSettings {
    int count = 12;
    ShotOrder order = ShotOrder::shuffle;
    std::uint64_t seed = 1;
    FilmShow film = FilmShow::side_by_side;
    std::chrono::nanoseconds dwell = std::chrono::seconds(20);      // that a shot stays at least
    std::chrono::nanoseconds max_dwell = std::chrono::seconds(60);  // stay, where whole loops would take more
    std::chrono::nanoseconds spacing = std::chrono::seconds(3);     // between two changes of turn
    std::chrono::nanoseconds lead = std::chrono::seconds(4);        // that the next shot is chosen early
    std::chrono::nanoseconds retry_after =
        std::chrono::seconds(60);  // before a file that failed is tried again
    SourceId last_source = 0;      // its own are numbered from there on: apart from those of other walls
};

/// What is on the wall: a fixed number of slots, each with a shot that after its time makes room for the
/// next in the same place.
/// Source: Dynamic Media Assemblage, chapter 4 ("we simply substitute the old shot with the new shot in the
/// same position"). Beyond: whose turn it is, one slot at a time, following a catalogue that changes.
///
/// Each shot comes once before any comes again but in its own file's only place, new files first; no shot
/// stands twice. As long as shots of
/// other files wait a file stands once; a film alone fills all slots with its shots in time order, which then
/// leave one after the other. Where all files fit on the wall, none ever leaves it altogether.
class WallSlots {
  public:
    explicit WallSlots(const SlotSettings& settings);

    /// Everything there is. What is gone or no longer ready leaves at once, a file that changed is loaded
    /// anew in its slots, free slots are filled.
    /// @param hints  of some of them: how long they stay, how often they come
    void set_catalogue(const RecordList& records, const ShowHints& hints = {});

    /// A turn that is asked for is taken whatever else is wished; a file that is pinned and not on the wall
    /// takes the next one.
    void set_controls(const ShowControls& controls);

    /// At most one shot whose time is nearly over makes room, so that the next can be got ready; free slots
    /// are filled.
    void advance(std::chrono::nanoseconds now);

    /// When the last shot that made room shall be gone; none: as soon as may be.
    std::optional<std::chrono::nanoseconds> due() const { return due_; }

    /// From then on the time of this shot counts.
    void shot_appeared(SourceId source, std::chrono::nanoseconds now);

    /// The file is avoided until it changes or some time has passed; its slots go to others.
    void source_failed(SourceId source, std::chrono::nanoseconds now);

    /// The shot leaves now for the next one; where there is none, it and its file do not come back for a
    /// while.
    void dismiss_shot(SourceId source, std::chrono::nanoseconds now);

    /// What is to be shown, in the order of the slots; free slots are left out.
    std::vector<WallShot> shots() const;

  private:
    struct Slot {
        std::optional<WallShot> shot;
        std::optional<std::chrono::nanoseconds> shown;
        std::chrono::nanoseconds ahead{0};  // of its time: leaves so much earlier
    };

    struct Turn {
        Slot* slot = nullptr;
        std::chrono::nanoseconds due{0};
        std::chrono::nanoseconds loop{0};  // of a film that is due at the end of one; else 0
    };

    bool is_pinned(const Slot& slot) const;
    const std::string* pinned_and_missing() const;
    std::optional<ShotKey> take_pinned(const std::string& path);
    void follow_changes(const std::map<std::string, RecordList::Record>& before);
    void fill();
    void spread(const std::vector<Slot*>& filled);
    std::chrono::nanoseconds leaves(const Turn& turn, std::chrono::nanoseconds earliest) const;
    std::vector<Turn> turns(std::chrono::nanoseconds until);
    std::chrono::nanoseconds stay(const WallShot& shot) const;
    std::optional<ShotKey> next_for(const Slot& slot);
    void put(Slot& slot, const ShotKey& key);
    bool is_on_wall(const ShotKey& key) const;
    long count_on_wall(const std::string& path) const;

    SlotSettings settings_;
    std::map<std::string, RecordList::Record> files_;  // what can be shown
    ShowHints hints_;
    std::map<std::string, std::chrono::nanoseconds> avoided_;  // until when
    ShotRotation rotation_;
    std::vector<Slot> slots_;
    SourceId last_source_;
    ShowControls controls_;
    std::uint64_t turns_taken_ = 0;          // of those wished
    std::chrono::nanoseconds next_turn_{0};  // not before
    std::optional<std::chrono::nanoseconds> due_;
    std::chrono::nanoseconds last_due_ = std::chrono::nanoseconds::min() / 2;
};

}  // namespace vitrine::player
