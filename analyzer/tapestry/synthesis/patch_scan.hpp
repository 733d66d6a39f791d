#pragma once

#include "analyzer/tapestry/synthesis/frame_signature.hpp"

#include <array>
#include <span>

namespace vitrine::analyzer {

constexpr int scan_lanes = 16;  // frames that are compared at once

/// Sixteen frames interleaved: for each channel of each pixel the sixteen values.
struct FrameBlock {
    static constexpr int values = 3 * FrameSignature::width * FrameSignature::height;

    alignas(32) std::array<std::uint8_t, std::size_t{scan_lanes} * values> lanes{};
};

/// @param frames  at most scan_lanes; lanes without a frame stay black
FrameBlock frame_block(std::span<const FrameSignature> frames);

/// Colour distances between a frame and each of a block, both ways.
struct ScanResult {
    std::array<float, scan_lanes> by_block{};  // mean distance of the frame's patches to the other's nearest
    std::array<float, scan_lanes> of_block{};  // mean distance of the other's patches to the frame's nearest
};

ScanResult scan_patches(const FrameSignature& frame, const FrameBlock& block);

}  // namespace vitrine::analyzer
