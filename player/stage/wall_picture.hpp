#pragma once

#include "player/display/picture.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <future>
#include <vector>

namespace vitrine::player {

class Renderer;

/// A frame as a small picture. @param max_side  px of the picture's longest side
Picture picture_of(const Frame& frame, int max_side, Renderer& renderer);

/// A small picture of the wall for those who drop files, STATE/wall.jpg: now and then, and a moment after
/// other shots are on it. It is written by a thread of its own, as disks may take long. Logs.
class WallPicture {
  public:
    static constexpr int max_side = 960;  // px

    static constexpr std::chrono::seconds first{3};

    explicit WallPicture(std::filesystem::path file) : file_(std::move(file)) {}

    /// Whether a picture of this frame is wanted.
    /// @param now  never goes back
    bool is_due(const Frame& frame, std::chrono::nanoseconds now);

    /// Nothing happens where it is the last one again, or that is still being written.
    void take(Picture picture);

  private:
    std::filesystem::path file_;
    std::vector<SourceId> sources_;  // on the wall when last asked
    std::chrono::nanoseconds next_ = first;
    std::chrono::nanoseconds earliest_ = first;  // that a change may bring it forward to
    std::vector<std::byte> taken_;               // pixels of the last one
    bool has_complained_ = false;
    std::future<bool> written_;  // last: its thread ends before the rest
};

}  // namespace vitrine::player
