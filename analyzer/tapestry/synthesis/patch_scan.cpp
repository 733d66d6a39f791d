// Compares patches of 7 x 7 for every displacement of one frame over the other. At each displacement the
// squared differences of the overlapping pixels are summed over 7 rows, then over 7 columns, by sliding, and
// each patch of both frames keeps its smallest sum. The sixteen lanes of a vector of 16-bit numbers hold
// sixteen pairs of frames. Two shifts keep the sums within 16 bits; they lose differences below two grey
// levels.

#include "analyzer/tapestry/synthesis/patch_scan.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace vitrine::analyzer {

namespace {

constexpr int width = FrameSignature::width;
constexpr int height = FrameSignature::height;
constexpr int side = 7;  // a patch's side, px
constexpr int patch_columns = width - side + 1;
constexpr int patch_rows = height - side + 1;
constexpr int patches = patch_columns * patch_rows;
constexpr int pixel_shift = 3;   // 3 * 127^2 >> 3, seven times: 16 bits
constexpr int column_shift = 3;  // that >> 3, seven times: 16 bits

using Bytes = std::uint8_t __attribute__((vector_size(scan_lanes)));
using Lanes = std::uint16_t __attribute__((vector_size(2 * scan_lanes)));

struct Scratch {
    std::array<Lanes, patches> nearest_of_frame;
    std::array<Lanes, patches> nearest_of_block;
    std::array<std::array<Lanes, width>, side> rows;  // pixel differences of the last seven rows
    std::array<Lanes, width> columns;                 // their sums, column by column
};

[[gnu::always_inline]] inline Lanes lesser(const Lanes& a, const Lanes& b) {
    return a < b ? a : b;
}

/// The squared difference of one pixel of the frame to a pixel of the block.
[[gnu::always_inline]] inline void pixel_difference(const std::uint8_t* pixel, const std::uint8_t* block,
                                                    Lanes& out) {
    const Lanes max_square = Lanes{} + std::uint16_t{127 * 127};
    Lanes sum{};
    for (std::size_t c = 0; c < 3; ++c) {
        Bytes others;
        std::memcpy(&others, block + c * scan_lanes, sizeof others);
        const Lanes difference = __builtin_convertvector(others, Lanes) - std::uint16_t{pixel[c]};
        const Lanes square = difference * difference;
        sum += lesser(square, max_square);
    }
    out = sum >> pixel_shift;
}

[[gnu::always_inline]] inline void keep_nearest(Scratch& scratch, int of_frame, int of_block, int count) {
    Lanes sum{};
    for (int x = 0; x < side - 1; ++x)
        sum += scratch.columns[static_cast<std::size_t>(x)] >> column_shift;
    for (int x = 0; x < count; ++x) {
        sum += scratch.columns[static_cast<std::size_t>(x + side - 1)] >> column_shift;
        Lanes& a = scratch.nearest_of_frame[as_index(of_frame + x)];
        Lanes& b = scratch.nearest_of_block[as_index(of_block + x)];
        a = lesser(a, sum);
        b = lesser(b, sum);
        sum -= scratch.columns[static_cast<std::size_t>(x)] >> column_shift;
    }
}

/// Compares at one displacement: pixel (x, y) of the frame lies on (x + dx, y + dy) of the block.
[[gnu::always_inline]] inline void displace(Scratch& scratch, const FrameSignature& frame,
                                            const FrameBlock& block, int dx, int dy) {
    const int overlap_width = width - std::abs(dx);
    const int overlap_height = height - std::abs(dy);
    const int x0 = std::max(0, -dx);
    const int y0 = std::max(0, -dy);
    scratch.columns.fill(Lanes{});
    for (int y = 0; y < overlap_height; ++y) {
        auto& row = scratch.rows[static_cast<std::size_t>(y % side)];
        const std::size_t of_frame = as_index((y0 + y) * width + x0);
        const std::size_t of_block = as_index((y0 + y + dy) * width + x0 + dx);
        for (std::size_t x = 0; x < static_cast<std::size_t>(overlap_width); ++x) {
            Lanes difference;
            pixel_difference(&frame.pixels[3 * (of_frame + x)], &block.lanes[3 * (of_block + x) * scan_lanes],
                             difference);
            if (y >= side) scratch.columns[x] -= row[x];
            scratch.columns[x] += difference;
            row[x] = difference;
        }
        const int top = y - side + 1;
        if (top < 0) continue;
        keep_nearest(scratch, (y0 + top) * patch_columns + x0, (y0 + top + dy) * patch_columns + x0 + dx,
                     overlap_width - side + 1);
    }
}

[[gnu::always_inline]] inline std::array<float, scan_lanes> mean(const std::array<Lanes, patches>& nearest) {
    constexpr float unit = float{1 << (pixel_shift + column_shift)} / (3 * side * side);
    std::array<std::uint32_t, scan_lanes> sums{};
    for (const Lanes& lanes : nearest)
        for (std::size_t i = 0; i < scan_lanes; ++i)
            sums[i] += lanes[i];
    std::array<float, scan_lanes> means{};
    for (std::size_t i = 0; i < scan_lanes; ++i)
        means[i] = static_cast<float>(sums[i]) * unit / patches;
    return means;
}

[[gnu::always_inline]] inline void scan(const FrameSignature& frame, const FrameBlock& block,
                                        ScanResult& out) {
    Scratch scratch;
    scratch.nearest_of_frame.fill(Lanes{} + std::uint16_t{65535});
    scratch.nearest_of_block.fill(Lanes{} + std::uint16_t{65535});
    for (int dy = 1 - patch_rows; dy < patch_rows; ++dy)
        for (int dx = 1 - patch_columns; dx < patch_columns; ++dx)
            displace(scratch, frame, block, dx, dy);
    out.by_block = mean(scratch.nearest_of_frame);
    out.of_block = mean(scratch.nearest_of_block);
}

void scan_plain(const FrameSignature& frame, const FrameBlock& block, ScanResult& out) {
    scan(frame, block, out);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void scan_avx2(const FrameSignature& frame, const FrameBlock& block,
                                               ScanResult& out) {
    scan(frame, block, out);
}
#endif

}  // namespace

FrameBlock frame_block(std::span<const FrameSignature> frames) {
    FrameBlock block;
    for (std::size_t i = 0; i < frames.size(); ++i)
        for (std::size_t value = 0; value < FrameBlock::values; ++value)
            block.lanes[value * scan_lanes + i] = frames[i].pixels[value];
    return block;
}

ScanResult scan_patches(const FrameSignature& frame, const FrameBlock& block) {
    ScanResult result;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) {
        scan_avx2(frame, block, result);
        return result;
    }
#endif
    scan_plain(frame, block, result);
    return result;
}

}  // namespace vitrine::analyzer
