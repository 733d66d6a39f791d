#pragma once

#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Repeats shots where a canvas has more displays than shots, so that each display can show one. Displays
/// that touch count as one (count_surfaces). The shots of a folder stand together: they count as one, and are
/// repeated together.
class RepeatedShots {
  public:
    /// @param numbers  the last number of a source, shared with all who number sources
    explicit RepeatedShots(std::shared_ptr<SourceId> numbers) : numbers_(std::move(numbers)) {}

    /// Adds copies after the shots until there is one for each display. A copy has a free slot and a source
    /// of its own, which it keeps for as long as its shot stands and it is needed. Leaves hidden shots out.
    std::vector<WallShot> with_copies(std::vector<WallShot> shots, std::size_t displays);

    /// The source of the shot of which this is a copy; of any other shot, its own.
    SourceId original_of(SourceId source) const;

    /// Hides one of several copies, as a visitor has dismissed it; the shot itself counts as one of them.
    /// @return false: nothing is hidden, as no other copy is seen
    bool hide(SourceId source, std::chrono::nanoseconds until);

    /// Shows again what was hidden until now.
    void advance(std::chrono::nanoseconds now);

  private:
    bool is_seen_elsewhere(SourceId source) const;

    using Copy = std::pair<SourceId, std::size_t>;  // the shot's source, and the number of its copy

    std::shared_ptr<SourceId> numbers_;
    std::map<Copy, SourceId> sources_;
    std::map<SourceId, std::chrono::nanoseconds> hidden_;  // source -> end
};

}  // namespace vitrine::player
