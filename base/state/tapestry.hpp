#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// One level of a tapestry: the whole film as a strip of tiles.
struct TapestryLevel {
    int width = 0;                                    // px of the strip
    std::vector<std::chrono::nanoseconds> keyframes;  // when they are, stream time, in order; at least one
    bool has_zoom = false;                            // there are zoom fields between it and the level before
};

/// What a tapestry's folder holds: docs/catalogue.md has the format.
struct Tapestry {
    std::string path;  // of the film, as its record names it
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;
    std::chrono::nanoseconds duration{0};
    bool is_complete = false;           // false: finer levels may still come
    std::string folder;                 // of the tiles, below the index
    int height = 0;                     // px of every strip
    int tile_width = 0;                 // px; the last tile of a level may be narrower
    int brick_width = 0;                // px; keyframes one after another are half of it apart
    std::vector<TapestryLevel> levels;  // coarsest first; each has all keyframes of the one before

    int tiles(std::size_t level) const;

    /// Below the index' folder.
    std::string tile_name(std::size_t level, int tile) const;

    /// Of a tile's zoom field to the level after its own or before it, below the index' folder.
    std::string zoom_name(std::size_t level, int tile, bool is_to_finer) const;

    /// Where a keyframe's middle lies, px of the strip.
    double middle(std::size_t level, std::size_t keyframe) const;

    /// From keyframe to keyframe in a straight line; the strip's ends are the film's.
    double x_at(std::size_t level, std::chrono::nanoseconds time) const;
    std::chrono::nanoseconds time_at(std::size_t level, double x) const;
};

std::string to_json(const Tapestry& tapestry);

/// @throws std::runtime_error where it is no index of this version, or says what cannot be
Tapestry tapestry_from_json(std::string_view json);

/// The index in a tapestry's folder. @throws std::system_error, std::runtime_error; both name the file
Tapestry read_tapestry(const std::filesystem::path& directory);

/// Where the tapestry of the film of that record is. @param path  as its record names it
std::filesystem::path tapestry_folder(const std::filesystem::path& state, const std::string& path);

/// Replaces the index by write, fsync and rename. @throws std::system_error
void write_tapestry(const std::filesystem::path& directory, const Tapestry& tapestry);

}  // namespace vitrine
