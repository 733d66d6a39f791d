#pragma once

#include "player/scene/change_pace.hpp"
#include "player/scene/folders/folder_stack.hpp"
#include "player/scene/show.hpp"

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// A wall of folders and files side by side. A tap on a folder opens it: its place grows until its own wall
/// is on the screen, with its sub-folders and files side by side, and so on to any depth. A tap on the way
/// back (back_mark), the key Back, or a while without a touch lets that wall shrink into its place again. The
/// wall behind stands still meanwhile, so all is where it was. All other gestures are those of a Wall.
/// Source: Dynamic Media Assemblage, chapter 4 and fig. 4.6; the zoom and the way back are ours.
class FolderWall final : public Show {
  public:
    FolderWall(const Canvas& canvas, const WallSettings& settings);

    /// Closes all folders at once.
    void set_canvas(const Canvas& canvas) override;

    using Show::set_catalogue;

    /// A folder without files is closed.
    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    void handle_gesture(const Gesture& gesture) override;
    std::optional<SeenShot> shot_at(Vec2 point) const override;
    void set_layout(const Layout& layout) override;
    void source_ready(SourceId source) override;
    void source_failed(SourceId source, std::chrono::nanoseconds now) override;

    /// An arrangement is one of the wall of all files: open folders are closed.
    void set_controls(const ShowControls& controls) override;
    WallStep step(std::chrono::nanoseconds now) override;

    ChangePace* pace() override { return wall().pace(); }

    std::string opened_folder() const override { return folders_.top().folder(); }

    std::vector<SlotShot> standing() const override { return wall().standing(); }

    std::set<std::string> avoided_files() const override { return wall().avoided_files(); }

    const FolderStack& folders() const { return folders_; }

    /// The place of the way back, canvas px. Empty: no folder is open.
    Box way_back() const { return folders_.depth() > 1 ? folders_.top().way_back() : Box{}; }

  private:
    using Time = std::chrono::nanoseconds;

    const Wall& wall() const { return folders_.top().wall(); }

    Wall& wall() { return folders_.top().wall(); }

    Time idle_;
    Canvas canvas_;
    RecordList records_;
    ShowHints hints_;
    ShowControls controls_;  // of open folders
    std::shared_ptr<const ArrangedWall> arranged_;
    FolderStack folders_;
    std::string wanted_;        // the folder that was tapped; empty: none
    std::size_t wished_depth_;  // number of walls that shall stay open
    Time touched_{0};
    Time now_{0};
};

}  // namespace vitrine::player
