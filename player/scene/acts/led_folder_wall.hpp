#pragma once

#include "player/scene/acts/led_show.hpp"
#include "player/scene/folders/folder_wall.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace vitrine::player {

/// A FolderWall that leads a wall of several boxes. It makes acts of the changes of the wall that is seen, as
/// a LedWall does, and one of each way into a folder and out of it. With the wall of a folder goes the one
/// behind it, of which the way back is a small picture.
class LedFolderWall final : public LedShow {
  public:
    /// @param settings  with a lead
    LedFolderWall(const Canvas& canvas, const WallSettings& settings)
        : style_(settings.transition), wall_(canvas, settings) {}

    using Show::set_catalogue;

    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    bool is_changing() const override;

    /// The way between two walls that is under way; none: a wall stands.
    const std::optional<FolderStack::Zoom>& zoom() const { return wall_.folders().zoom(); }

  private:
    /// The walls as an act tells of them. Another value needs another act.
    struct View {
        std::size_t seen = 0;  // the number of the wall that is seen, or to which the way leads
        std::string folder;
        std::optional<FolderStack::Zoom> zoom = {};
        std::optional<std::chrono::nanoseconds> stands_at = {};  // of the wall behind it

        bool operator==(const View&) const = default;
    };

    Show& inner() override { return wall_; }

    const Show& inner() const override { return wall_; }

    void make_news() override;
    LiftedMoment lifted() const override;

    std::chrono::nanoseconds local_time() const override { return level(told_.seen).local(now()); }

    View view() const;

    const OpenFolder& level(std::size_t number) const { return wall_.folders().levels()[number]; }

    void prepare_walls();
    ActFolder folder_behind(std::size_t number) const;

    TransitionStyle style_;
    FolderWall wall_;
    std::size_t depth_ = 1;                                   // number of walls at the last step
    std::uint64_t prepared_change_ = 0;                       // generation of the change of the wall on top
    std::optional<std::chrono::nanoseconds> prepared_close_;  // when that was asked for
    View told_;                                               // as of the last step
    std::uint64_t told_change_ = 0;  // generation of the change of the wall that is seen; 0: none
};

}  // namespace vitrine::player
