#pragma once

#include "base/state/tapestry.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace vitrine::player {

/// Notices when the analyzer has replaced the index of a tapestry.
class NewerIndex {
  public:
    /// @param directory  the tapestry's; it may not be there yet
    explicit NewerIndex(std::filesystem::path directory) : directory_(std::move(directory)) {}

    /// The index as it is now, if it has not been read before. Looks at most ten times a second.
    /// @param now  never goes back
    std::optional<Tapestry> take(std::chrono::nanoseconds now);

    /// Call before the present index is read elsewhere.
    void pass_over() { known_ = present(); }

  private:
    using Version = std::pair<std::uint64_t, std::int64_t>;  // inode, modification time in ns; 0: no index

    Version present() const;

    std::filesystem::path directory_;
    Version known_{0, 0};
    std::optional<std::chrono::nanoseconds> looked_;
};

}  // namespace vitrine::player
