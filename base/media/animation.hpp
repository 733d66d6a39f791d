#pragma once

#include "base/media/colour.hpp"
#include "base/media/media_type.hpp"

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

// Limits of animations. Those beyond them are refused by their header, before a picture is decoded.
constexpr std::int64_t max_animation_pixels = 16'777'216;  // of one picture, which is decoded as a whole
constexpr int max_animation_side = 16'384;                 // px
constexpr int max_animation_pictures = 10'000;
constexpr std::int64_t max_animation_rows = 10'000'000;  // of all pictures together, as libvips has it

/// A container's duration of a picture that is as short as this is a mistake, and counts as `usual_duration`,
/// as in web browsers.
constexpr std::chrono::milliseconds mistaken_duration{10};
constexpr std::chrono::milliseconds usual_duration{100};

/// The header of an animation.
struct AnimationInfo {
    int width = 0;  // px
    int height = 0;
    std::vector<std::chrono::nanoseconds> durations;  // of each picture

    std::chrono::nanoseconds duration() const;
};

/// One way to read the pictures of an animation, in their order.
class AnimationReader {
  public:
    AnimationReader() = default;
    AnimationReader(const AnimationReader&) = delete;
    AnimationReader& operator=(const AnimationReader&) = delete;
    virtual ~AnimationReader() = default;

    virtual const AnimationInfo& info() const = 0;

    /// The next picture as it is shown, with what earlier ones have left. RGBX, 8 bits a channel, rows
    /// without gaps. @throws MediaError
    /// @pre there is one
    virtual std::vector<std::byte> next() = 0;
};

/// Opens a GIF or a WebP at its first picture.
/// @param background  the colour behind transparent parts
/// @throws MediaError if the file is damaged, or beyond the limits
std::unique_ptr<AnimationReader> open_vips_animation(const std::string& path, MediaFormat format,
                                                     Colour background);

/// @param pictures  their number, as the file says
/// @throws MediaError if an animation of this size is beyond the limits
void require_animation_within_limits(int width, int height, std::int64_t pictures);

/// The duration of a picture for which the container says this.
std::chrono::nanoseconds picture_duration(std::chrono::nanoseconds said);

}  // namespace vitrine
