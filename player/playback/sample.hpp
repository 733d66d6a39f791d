#pragma once

#include "base/geometry/vec2.hpp"
#include "player/playback/colour_code.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace vitrine::player {

/// The layout of a picture's bytes, 8 bits a channel.
enum class PixelLayout {
    rgba,  // one plane, opaque
    bgra,  // like rgba, in the order that Mesa's software renderer copies without looking at each pixel
    i420,  // a plane of brightness, then two of colour differences with half the columns and rows, rounded up
    nv12,  // a plane of brightness, then one plane with both differences side by side
};

/// True if the pixels are colours, not brightness and differences.
inline bool is_rgb(PixelLayout layout) {
    return layout == PixelLayout::rgba || layout == PixelLayout::bgra;
}

/// The form of pictures that the renderer draws at the least cost. A graphics card draws the decoder's
/// planes: uploaded or, if it can, in the decoder's own memory (shared). If the processor draws, BGRA at the
/// shown size costs least.
enum class PictureForm { bgra, planes, shared };

/// The planes of a picture in memory that both a graphics card and the processor can read: Linux' dma-bufs.
struct SharedPlanes {
    struct Plane {
        int file = -1;             // descriptor of the memory, lent by the sample's owner
        std::uint32_t offset = 0;  // bytes
        std::uint32_t stride = 0;  // bytes a row
    };

    std::array<Plane, 3> planes;            // the layout says how many of them are used
    std::optional<std::uint64_t> modifier;  // DRM's number for the order of the pixels; none: row by row
};

/// One picture ready for the renderer: upright; its pixels are square at the size asked for.
struct Sample {
    struct Plane {
        std::size_t stride = 0;            // bytes a row
        std::span<const std::byte> bytes;  // lent by the sample's owner
    };

    int width = 0;  // px
    int height = 0;
    std::size_t stride = 0;             // bytes a row
    std::span<const std::byte> pixels;  // height * stride bytes, lent by `owner`; for planes, the brightness
    PixelLayout layout = PixelLayout::rgba;
    std::array<Plane, 2> chroma;              // i420 uses both, nv12 the first
    ColourCode colours;                       // for planes, not for rgba and bgra
    std::shared_ptr<const void> owner;        // shared by the decoder's buffer pool and the renderer's queue
    std::chrono::nanoseconds stream_time{0};  // its time in the film
    Vec2 slide;  // drift * time into the shot, source px: the texel at canvas point u is
                 // (u - offset) / scale + slide

    /// The memory of the planes. If set, `pixels` and `chroma` have no bytes.
    std::optional<SharedPlanes> shared;
    std::function<std::optional<Sample>()>
        copied;  // makes the same sample with bytes, if shared planes cannot be read
};

}  // namespace vitrine::player
