#pragma once

#include "player/scene/crossfade.hpp"
#include "player/scene/drag.hpp"
#include "player/scene/enlargement.hpp"
#include "player/scene/show.hpp"
#include "player/scene/transition.hpp"
#include "player/scene/wall_slots.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

struct WallSettings {
    SlotSettings slots;
    TransitionStyle transition;
    bool nests = false;                                            // the files of a folder stand together
    std::chrono::nanoseconds patience = std::chrono::seconds(10);  // with a source that does not get ready
    EditRules touch;                                               // by which a finger moves shots
    std::chrono::nanoseconds idle = std::chrono::seconds(30);      // after which what was tapped goes back
};

/// The number of the folder under the media root that a file lies in, as PlanItem::group.
/// @param folders  those known; a new one is added
int folder_number(const std::string& path, std::map<std::string, int>& folders);

/// The wall from wish to picture. What the slots wants is planned; once its layout is there its
/// sources are asked for; once they are ready and the shot that goes has had its time, the old wall, which
/// plays on, moves and fades into the new one; then the sources that are not on it any more retire. One such
/// change at a time; a wish that changes before its fade has begun is replaced. The first wall waits for none
/// but its first source: its shots fade in over the idle picture, each when it is ready.
///
/// A change moves what stays as little as can be. Where that leaves much more of the canvas to waste than
/// walls that are laid out anew do, the change is laid out anew.
class Wall final : public Show {
  public:
    Wall(Vec2 canvas, const WallSettings& settings);

    /// Another screen mode: the same shots are laid out anew.
    void set_canvas(Vec2 canvas) override;

    using Show::set_catalogue;
    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    /// What a finger drags follows it; what it taps grows, and goes back by itself; what it holds is large
    /// until it is let go; what it flicks out of the canvas leaves, and the next shot comes. Nothing else
    /// changes before all has settled again. Folders that stand together cannot be touched.
    void handle_gesture(const Gesture& gesture) override;

    std::optional<ShotKey> shot_at(Vec2 point) const override;

    /// A layout of a plan of this wall, in the order of its items; of an outdated plan it is ignored. For the
    /// first wall also those before the last are taken: while that is made its sources get ready.
    /// @pre one placement for each item of the plan
    void set_layout(const Layout& layout) override;

    void source_ready(SourceId source) override;

    /// Its file gives way to another; what is on the wall of it stays until the other is ready.
    void source_failed(SourceId source, std::chrono::nanoseconds now) override;

    void set_controls(const ShowControls& controls) override { slots_.set_controls(controls); }

    /// @param now  since the player's start; never goes back
    WallStep step(std::chrono::nanoseconds now) override;

    std::size_t count() const override { return shown_.size(); }

    std::vector<SlotShot> standing() const override;

    bool is_fading() const { return incoming_ && incoming_->fade_began.has_value(); }

    /// Whether the first wall comes, each shot when it is ready.
    bool is_arriving() const { return is_fading() && shown_.empty(); }

    /// What is on the wall without what fades in.
    std::span<const PlacedShot> shown() const { return shown_; }

  private:
    enum class Source { asked, ready, failed };

    struct Incoming {
        std::uint64_t generation = 0;
        Vec2 canvas;  // px
        std::vector<PlacedShot> wall;
        bool has_layout = false;
        bool is_final = false;         // the layout: no better one follows
        bool is_anew = false;          // laid out without regard to where things stand
        std::vector<PlacedShot> calm;  // the same shots where they moved little, if that left much empty
        bool wants_sources = false;    // of another size than asked for, or not asked for yet
        bool is_by_hand = false;
        std::optional<std::chrono::nanoseconds> pace;     // by hand: of its one act; none: the usual style
        std::optional<std::chrono::nanoseconds> waiting;  // for the sources since
        std::optional<std::chrono::nanoseconds> fade_began;
        std::vector<Act> acts;  // of the transition, once it has begun
    };

    void end_fade(std::chrono::nanoseconds now);
    void let_arrive(std::chrono::nanoseconds now);
    bool has_arrived(std::chrono::nanoseconds now) const;
    void follow_store();
    void follow_hand(std::chrono::nanoseconds now);
    void change_by_hand(std::vector<PlacedShot> wall, std::optional<std::chrono::nanoseconds> pace);
    void dismiss(std::chrono::nanoseconds now);
    const PlacedShot* touched(Vec2 point) const;
    bool leaves(const Gesture& flick) const;
    std::optional<WallPlan> follow_assemblage();
    std::optional<WallPlan> ask_anew();
    void choose_layout();
    WallPlan begin_change(const std::vector<WallShot>& wanted);
    PlanItem plan_item(const WallShot& shot) const;
    void prepare(WallStep& step, std::chrono::nanoseconds now);
    bool is_ready() const;
    void give_up_waiting(std::chrono::nanoseconds now);
    std::vector<Act> acts() const;
    void begin_fade(std::chrono::nanoseconds now);
    std::vector<SourceId> retire();
    Frame picture(std::chrono::nanoseconds now) const;

    WallSettings settings_;
    Vec2 canvas_;
    WallSlots slots_;
    Drag drag_;
    Enlargement enlargement_;
    SourceId dismissed_ = 0;          // to leave; 0: none
    std::map<int, Seat> left_seats_;  // of slots whose shots were dismissed
    std::vector<PlacedShot> shown_;
    std::optional<Incoming> incoming_;
    Vec2 shown_canvas_;  // that shown_ was laid out for
    bool is_canvas_new_ = false;
    double usual_waste_ = 1;  // of walls laid out anew
    std::uint64_t generation_ = 0;
    std::map<SourceId, Source> sources_;  // those not retired
    std::vector<ShotRequest> restored_;   // of sources asked for, whose shot the store has got since
};

}  // namespace vitrine::player
