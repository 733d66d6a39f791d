#pragma once

#include "base/settings/canvas_words.hpp"
#include "player/layout/canvas.hpp"
#include "player/render/view.hpp"
#include "player/scene/acts/wall_act.hpp"
#include "player/stage/canvas_guide.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vitrine {

struct Settings;

}

namespace vitrine::player {

class Screen;

/// The facts of an output: its name and px, and its view without a canvas.
struct KnownOutput {
    std::string name;
    int width = 0;  // px
    int height = 0;
    View view;

    bool operator==(const KnownOutput&) const = default;
};

/// The other boxes of a wall. Their outputs are named BOX/OUTPUT.
struct OtherOutputs {
    std::vector<KnownOutput> outputs;
    bool has_guides = false;  // the box that leads draws guides on its own
    bool are_awake = false;   // a touch has lit the panels of one of them
};

/// An output's part of the canvas.
struct OutputPart {
    Box box;  // canvas px
    Rotation rotation = Rotation::none;

    bool operator==(const OutputPart&) const = default;
};

/// A canvas and the parts that outputs show of it.
struct SharedCanvas {
    Canvas canvas;                            // px; empty: none of the outputs is named
    std::map<std::string, OutputPart> parts;  // by the outputs' names

    bool operator==(const SharedCanvas& other) const {
        return canvas == other.canvas && canvas.unit == other.canvas.unit &&
               canvas.origin == other.canvas.origin && parts == other.parts;
    }
};

/// A screen that waits until a wall is laid out for its canvas shows the idle picture in this view.
struct ComingView {
    Vec2 canvas;  // its size, px of the canvas that is seen so far
    Vec2 origin;  // its top left corner there
    View view;
};

/// The canvas for some outputs. The one with most px on a unit of length has them on the canvas, too, unless
/// the canvas gets longer than 16384 px; so no picture is drawn larger than its canvas.
/// @param outputs  those that are named; others have no part
SharedCanvas shared_canvas(const CanvasWords& words, std::span<const KnownOutput> outputs);

/// The words of output.canvas, in which the outputs of this box are named as the box names them.
CanvasWords own_canvas_words(const Settings& settings);

KnownOutput known_output(const Settings& settings, const Screen& screen);

/// The canvas that outputs show together (`output.canvas`), as they come and go. An output that is pulled out
/// keeps its place for a minute: the others show what they showed. Logs.
class OutputCanvas {
  public:
    /// @param settings  outlive this
    /// @param others    outputs of other boxes, as they are now
    explicit OutputCanvas(const Settings& settings, std::shared_ptr<const OtherOutputs> others = {})
        : settings_(settings), others_(std::move(others)) {}

    /// Takes the outputs that are there now. @param now  since the player's start
    void follow(std::span<Screen* const> screens, std::chrono::nanoseconds now);

    /// Takes all outputs that are named as if they were there with these px, while nothing is open.
    void expect(int width, int height);

    /// True: other boxes have outputs.
    bool has_others() const { return others_ && !others_->outputs.empty(); }

    /// True: outputs show parts of one canvas.
    bool is_shared() const { return !now_.parts.empty(); }

    const SharedCanvas& shared() const { return now_; }

    /// The parts of all outputs on the canvas, and on the one before.
    std::vector<ActParts> parts() const;

    /// Takes the canvas of an act, and the parts that this box has of it.
    void show_parts(const WallAct& act);

    /// The part of a frame's canvas that a screen shows. A frame of the canvas before is drawn as before; an
    /// output that is new since then has its part where it hangs, which may be beyond that canvas.
    View view_on(const Screen& screen, Vec2 canvas) const;

    /// True if a screen hangs beyond a frame's canvas, in whole or in part: it waits for the canvas to come.
    bool is_beyond(const Screen& screen, Vec2 canvas) const;

    /// The view of such a screen on the canvas to come.
    ComingView coming_view(const Screen& screen, Vec2 canvas) const;

    /// The facts that a guide on a screen draws.
    GuideView guide_view(const Screen& screen, Vec2 canvas) const;

  private:
    struct Seen {
        KnownOutput output;
        std::chrono::nanoseconds first{0};  // when it came
        std::chrono::nanoseconds last{0};   // when it was there
    };

    void read_words();
    void see(const KnownOutput& output, std::chrono::nanoseconds now);
    void take(SharedCanvas shared);
    void add_new_outputs();
    bool is_new(const std::string& output) const;
    const SharedCanvas& shared_of(Vec2 canvas) const;
    const OutputPart* part_of(const Screen& screen, Vec2 canvas) const;
    std::map<std::string, ActPart> act_parts(const SharedCanvas& shared) const;

    const Settings& settings_;  // outlive this
    std::shared_ptr<const OtherOutputs> others_;
    std::string text_;  // of words_
    CanvasWords words_;
    std::vector<Seen> seen_;
    SharedCanvas now_;
    SharedCanvas before_;
};

}  // namespace vitrine::player
