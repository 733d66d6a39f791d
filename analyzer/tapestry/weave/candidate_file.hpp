#pragma once

#include "analyzer/tapestry/synthesis/frame_signature.hpp"

#include <array>
#include <cstdint>
#include <type_traits>

// The file in which the frames of a film wait to be woven: their JPEGs one after another, then the film's
// record as JSON, then an entry for each frame, then the end, where reading begins. Only this build on this
// machine can read it.

namespace vitrine::analyzer {

/// Identifies the content of a film.
struct FilmContent {
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;

    bool operator==(const FilmContent&) const = default;
};

struct CandidateEntry {
    std::int64_t time_ns = 0;
    std::int64_t offset = 0;  // place of its JPEG
    std::int64_t bytes = 0;
    std::array<std::uint8_t, std::tuple_size_v<decltype(FrameSignature::pixels)>> signature{};
};

struct CandidateFileEnd {
    static constexpr std::uint64_t usual_mark = 0x3374656d61726676;  // "vframet3"

    FilmContent content;
    std::int64_t duration_ns = 0;
    std::int64_t entries_offset = 0;
    std::int64_t entries = 0;
    std::int64_t record_bytes = 0;  // right before the entries
    std::int32_t brick_width = 0;   // px
    std::int32_t brick_height = 0;
    std::int32_t frame_width = 0;  // px of the frames, which kept pictures with bars have
    std::int32_t frame_height = 0;
    std::array<std::int32_t, 4>
        active{};  // the picture within its bars: left, top, width, height, px of the frames
    std::uint64_t mark = usual_mark;
};

static_assert(std::is_trivially_copyable_v<CandidateEntry> && std::is_trivially_copyable_v<CandidateFileEnd>);

}  // namespace vitrine::analyzer
