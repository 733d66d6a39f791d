#pragma once

#include "base/settings/choices.hpp"
#include "base/state/record.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_chooser.hpp"
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
    std::chrono::nanoseconds dwell = std::chrono::seconds(20);      // shortest time that a shot stays
    std::chrono::nanoseconds max_dwell = std::chrono::seconds(60);  // with whole loops that take longer
    std::chrono::nanoseconds spacing = std::chrono::seconds(3);     // between two changes of turn
    std::chrono::nanoseconds lead = std::chrono::seconds(4);  // time by which the next shot is chosen early
    std::chrono::nanoseconds retry_after = std::chrono::seconds(60);  // for a file that failed
    SourceId last_source = 0;  // its own sources are numbered from there on, apart
                               // from those of other walls
};

/// The shots on a wall: a fixed number of slots, each with a shot that after its time makes room for the next
/// one in the same place. ShotChooser decides which comes next. Source: Dynamic Media Assemblage, chapter 4
/// ("we simply substitute the old shot with the new shot in the same position"). Ours: the choice of the slot
/// whose turn it is, one at a time, and a catalogue that changes.
///
/// If all files fit on the wall, none ever leaves it altogether. The shots of a
/// film alone on the wall leave one after the other.
class WallSlots {
  public:
    explicit WallSlots(const SlotSettings& settings);

    /// Sets the files there are. Files that are gone or not ready any more leave
    /// at once, a file that changed is loaded anew in its slots, free slots are
    /// filled.
    /// @param hints  how long files stay and how often they come
    void set_catalogue(const RecordList& records, const ShowHints& hints = {});

    /// A turn that is asked for is taken whatever else holds; a file that is
    /// pinned and not on the wall takes the next one.
    void set_controls(const ShowControls& controls);

    /// Replaces at most one shot whose time is nearly over, so that the next one
    /// can be got ready; fills free slots.
    void advance(std::chrono::nanoseconds now);

    /// The time at which the shot that was replaced last leaves; none: as soon as possible.
    std::optional<std::chrono::nanoseconds> due() const { return due_; }

    /// The time of this shot counts from now on.
    void shot_appeared(SourceId source, std::chrono::nanoseconds now);

    /// Avoids the file until it changes or `retry_after` has passed; its slots go
    /// to others.
    void source_failed(SourceId source, std::chrono::nanoseconds now);

    /// Replaces the shot now; if there is no next one, its file is avoided for
    /// `retry_after`.
    void dismiss_shot(SourceId source, std::chrono::nanoseconds now);

    /// The shots to be shown, in the order of the slots, without free slots.
    std::vector<WallShot> shots() const;

  private:
    struct Slot {
        std::optional<WallShot> shot;
        std::optional<std::chrono::nanoseconds> shown;
        std::chrono::nanoseconds ahead{0};  // time by which it leaves early
    };

    struct Turn {
        Slot* slot = nullptr;
        std::chrono::nanoseconds due{0};
        std::chrono::nanoseconds loop{0};  // a film's loop, if it is due at the end of one; else 0
    };

    bool is_pinned(const Slot& slot) const;
    const std::string* pinned_and_missing() const;
    void follow_changes(const WallFiles& before);
    void fill_slots();
    void spread_leaving(const std::vector<Slot*>& filled);
    std::chrono::nanoseconds leaving_time(const Turn& turn, std::chrono::nanoseconds earliest) const;
    std::vector<Turn> due_turns(std::chrono::nanoseconds until);
    std::chrono::nanoseconds time_to_stay(const WallShot& shot) const;
    std::optional<ShotKey> choose_shot(const Slot& slot);
    void put_shot(Slot& slot, const ShotKey& key);
    long count_on_wall(const std::string& path) const;

    SlotSettings settings_;
    WallFiles files_;
    ShowHints hints_;
    ShotChooser chooser_;
    std::vector<Slot> slots_;
    SourceId last_source_;
    ShowControls controls_;
    std::uint64_t turns_taken_ = 0;          // number of the wished turns that were taken
    std::chrono::nanoseconds next_turn_{0};  // not before
    std::optional<std::chrono::nanoseconds> due_;
    std::chrono::nanoseconds last_due_ = std::chrono::nanoseconds::min() / 2;
};

}  // namespace vitrine::player
