#pragma once

#include "player/scene/show.hpp"

#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// A show around another one, to which it passes all on. What it does besides is in classes that override it.
class ForwardingShow : public Show {
  public:
    using Show::set_catalogue;

    void set_canvas(const Canvas& canvas) override { inner().set_canvas(canvas); }

    void set_catalogue(const RecordList& records, const ShowHints& hints) override {
        inner().set_catalogue(records, hints);
    }

    void set_layout(const Layout& layout) override { inner().set_layout(layout); }

    void source_ready(SourceId source) override { inner().source_ready(source); }

    void source_failed(SourceId source, std::chrono::nanoseconds now) override {
        inner().source_failed(source, now);
    }

    void handle_gesture(const Gesture& gesture) override { inner().handle_gesture(gesture); }

    std::optional<SeenShot> shot_at(Vec2 point) const override { return inner().shot_at(point); }

    void set_controls(const ShowControls& controls) override { inner().set_controls(controls); }

    WallStep step(std::chrono::nanoseconds now) override { return inner().step(now); }

    ChangePace* pace() override { return inner().pace(); }

    std::string opened_folder() const override { return inner().opened_folder(); }

    std::vector<SlotShot> standing() const override { return inner().standing(); }

    std::set<std::string> avoided_files() const override { return inner().avoided_files(); }

  private:
    virtual Show& inner() = 0;
    virtual const Show& inner() const = 0;
};

}  // namespace vitrine::player
