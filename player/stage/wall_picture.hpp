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

/// Draws a frame as a small picture. @param max_side  px of the picture's longest side
Picture picture_of(const Frame& frame, int max_side, Renderer& renderer);

/// Writes STATE/wall.jpg, a small picture of the wall for the operators: every half minute, and a moment
/// after the shots have changed. Writes in a thread of its own, because a disk may take long. Logs.
class WallPicture {
  public:
    static constexpr int max_side = 960;  // px

    static constexpr std::chrono::seconds first{3};

    explicit WallPicture(std::filesystem::path file) : file_(std::move(file)) {}

    /// True: a picture of this frame must be written.
    /// @param now  never goes back
    bool is_due(const Frame& frame, std::chrono::nanoseconds now);

    /// Writes the picture, unless it equals the last one or the last one is still being written.
    void write(Picture picture);

  private:
    std::filesystem::path file_;
    std::vector<SourceId> sources_;  // on the wall at the last is_due()
    std::chrono::nanoseconds next_ = first;
    std::chrono::nanoseconds earliest_ = first;  // no picture is written before this time
    std::vector<std::byte> pixels_;              // the last picture's pixels
    bool has_complained_ = false;
    std::future<bool> written_;  // last: its thread ends before the rest
};

}  // namespace vitrine::player
