#pragma once

#include "player/scene/files/group_turns.hpp"
#include "player/scene/files/shot_chooser.hpp"
#include "player/scene/files/shot_rotation.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/wall_shot.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::player {

/// Chooses the next shots of a panning wall. The shots take turns; if there are too few files, a shot may be
/// on the wall twice.
class PanningShots {
  public:
    /// @param last_source  sources are numbered from here on
    PanningShots(ShotOrder order, std::uint64_t seed, SourceId last_source)
        : rotation_(order, seed), last_source_(last_source) {}

    void set_files(const RecordList& records, const ShowHints& hints);

    bool has_file(const std::string& path) const { return files_.all().contains(path); }

    bool is_empty() const { return files_.all().is_empty(); }

    /// The number of shots that take turns, at most `most`.
    std::size_t count_shots(std::size_t most) const;

    /// @param is_on_wall  true: the shot is on the wall already
    std::vector<WallShot> next_shots(std::size_t count,
                                     const std::function<bool(const ShotKey&)>& is_on_wall);

    /// The number of a further source, for a shot that comes back.
    SourceId next_source() { return ++last_source_; }

  private:
    WallFiles files_;
    GroupTurns groups_;
    ShotRotation rotation_;  // of one file a group
    SourceId last_source_;
};

}  // namespace vitrine::player
