#pragma once

#include "player/scene/shot_chooser.hpp"
#include "player/scene/shot_rotation.hpp"
#include "player/scene/show_files.hpp"
#include "player/scene/wall_shot.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The shots that come next on a panning wall. Each shot comes in its turn; if there are too few files, a
/// shot may stand a second time.
class PanningShots {
  public:
    /// @param last_source  sources are numbered from there on
    PanningShots(ShotOrder order, std::uint64_t seed, SourceId last_source)
        : rotation_(order, seed), last_source_(last_source) {}

    void set_files(const RecordList& records, const ShowHints& hints);

    bool has_file(const std::string& path) const { return files_.contains(path); }

    bool is_empty() const { return files_.empty(); }

    /// @param is_on_wall  whether a shot stands already
    std::vector<WallShot> next_shots(std::size_t count,
                                     const std::function<bool(const ShotKey&)>& is_on_wall);

  private:
    WallFiles files_;
    ShotRotation rotation_;
    SourceId last_source_;
};

}  // namespace vitrine::player
