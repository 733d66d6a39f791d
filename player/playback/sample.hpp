#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>

namespace vitrine {

/// One picture ready for the renderer: upright, square pixels, RGBA with 8 bits a channel, opaque.
struct Sample {
    int width = 0;  // px
    int height = 0;
    std::size_t stride = 0;                   // bytes a row
    std::span<const std::byte> pixels;        // height * stride bytes, lent by `owner`
    std::shared_ptr<const void> owner;        // shared: the decoder's buffer pool and the renderer's queue
    std::chrono::nanoseconds stream_time{0};  // when in the film
};

}  // namespace vitrine
