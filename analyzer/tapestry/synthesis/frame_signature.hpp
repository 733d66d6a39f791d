#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace vitrine::analyzer {

/// A frame made small to compare it with others: 32 x 18 px, BGR, rows from the top. CandidateWriter makes it
/// while the film is decoded.
struct FrameSignature {
    static constexpr int width = 32;
    static constexpr int height = 18;

    std::chrono::nanoseconds time{0};
    std::array<std::uint8_t, std::size_t{3} * width * height> pixels{};
};

}  // namespace vitrine::analyzer
