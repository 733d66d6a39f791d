#pragma once

#include "player/scene/folders/open_folder.hpp"
#include "player/scene/show.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The walls of folders that are open behind one another, and the way between the last two. The wall on top
/// is seen and changes. The one behind it stands still, the others do without their sources.
class FolderStack {
  public:
    FolderStack(const Canvas& canvas, const WallSettings& settings);

    /// The way between the last two walls.
    struct Zoom {
        bool is_opening = true;
        std::chrono::nanoseconds asked{0};              // when it was asked for
        std::optional<std::chrono::nanoseconds> began;  // none: it waits for sources
        Box box;                                        // of the folder on the outer wall, canvas px

        bool operator==(const Zoom&) const = default;
    };

    OpenFolder& top() { return levels_.back(); }

    const OpenFolder& top() const { return levels_.back(); }

    /// All walls; the first is that of all files, each further one of a folder of the one before.
    std::vector<OpenFolder>& levels() { return levels_; }

    const std::vector<OpenFolder>& levels() const { return levels_; }

    /// The way under way; none: the wall on top stands.
    const std::optional<Zoom>& zoom() const { return zoom_; }

    /// The number of walls.
    std::size_t depth() const { return levels_.size(); }

    void set_canvas(const Canvas& canvas);

    /// True from the wish for another wall until it is there.
    bool is_on_way() const { return zoom_.has_value(); }

    /// Begins to open a folder of the wall on top.
    /// @param files  those of the folder; at least one
    void open(const std::string& folder, const RecordList& files, const ShowHints& hints,
              const ShowControls& controls);

    /// Begins to close the folder on top. @pre more than one wall
    void close();

    void set_layout(const Layout& layout);

    WallStep step(std::chrono::nanoseconds now);

  private:
    using Time = std::chrono::nanoseconds;

    OpenFolder& outer() { return levels_[levels_.size() - 2]; }

    void step_top(WallStep& step);
    void advance_zoom(WallStep& step);
    bool has_outermost_sources() const;
    void end_zoom(WallStep& step);
    double opened_share() const;
    Frame composed_frame() const;

    WallSettings settings_;
    Canvas canvas_;
    std::vector<OpenFolder> levels_;
    std::optional<Zoom> zoom_;
    Time now_{0};
    std::uint64_t generation_ = 0;       // of the last plan, whichever wall asked for it
    std::uint64_t inner_ = 0;            // the same on the counter of that wall
    std::vector<ShotRequest> requests_;  // since the last step
};

}  // namespace vitrine::player
