#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// One level of a tapestry: the whole film as a row of tiles.
struct TapestryLevel {
    int width = 0;                                    // px
    std::vector<std::chrono::nanoseconds> keyframes;  // stream times, in order; at least one
    bool has_zoom = false;                            // zoom fields lead to it from the level before
};

/// Frames of the film, so that the picture of any moment can be shown at once: sheets of equal cells, in time
/// order, row by row.
struct KeptSheets {
    int width = 0;  // px of a frame; 0: none are kept
    int height = 0;
    int columns = 0;  // frames in a row of a sheet
    int rows = 0;
    std::vector<std::chrono::nanoseconds> times;  // of the frames: stream times, in order

    bool is_empty() const { return times.empty(); }

    std::size_t frames_of_a_sheet() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }

    int sheets() const;

    /// The frame nearest to a time. @pre there is one
    std::size_t nearest(std::chrono::nanoseconds time) const;
};

/// A picture of the digits 0 to 9 and a colon, side by side, white on black.
struct DigitCells {
    int width = 0;  // px of one digit; 0: there is no such picture
    int height = 0;
};

/// The index in a tapestry's folder. docs/catalogue.md has the format.
struct Tapestry {
    std::string path;  // the film's path in its record
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;
    std::string choice{};  // key of the keyframes that a person has chosen; "": none
    std::chrono::nanoseconds duration{0};
    bool is_complete = false;           // false: finer levels may still come
    std::string folder;                 // folder of the tiles, below the index
    int height = 0;                     // px, the same for every level
    int tile_width = 0;                 // px; the last tile of a level may be narrower
    int brick_width = 0;                // px; neighbouring keyframes are half of it apart
    std::vector<TapestryLevel> levels;  // coarsest first; each has all keyframes of the level before
    KeptSheets kept{};
    DigitCells digits{};

    int tiles(std::size_t level) const;

    /// The name of a tile's file, below the index' folder.
    std::string tile_name(std::size_t level, int tile) const;

    /// The name of the file with a tile's zoom field to the next finer or coarser level, below the index'
    /// folder.
    std::string zoom_name(std::size_t level, int tile, bool is_to_finer) const;

    /// The names of the file of a sheet of kept frames, and of the picture of digits, below the index'
    /// folder.
    std::string sheet_name(int sheet) const;
    std::string digits_name() const;

    /// The middle of a keyframe, px of the level.
    double middle(std::size_t level, std::size_t keyframe) const;

    /// The time of a keyframe, a moment away from the film's ends: half a brick is drawn before the first
    /// keyframe and behind the last one, and it has times of its own.
    std::chrono::nanoseconds keyframe_time(std::size_t level, std::size_t keyframe) const;

    // Conversions between place and time on a level. Both are interpolated between keyframes; the ends of the
    // level are the ends of the film.
    double x_at(std::size_t level, std::chrono::nanoseconds time) const;
    std::chrono::nanoseconds time_at(std::size_t level, double x) const;
};

std::string to_json(const Tapestry& tapestry);

/// @throws std::runtime_error if the text is no index of this version or has impossible values
Tapestry tapestry_from_json(std::string_view json);

/// Reads the index in a tapestry's folder. @throws std::system_error, std::runtime_error; both name the file
Tapestry read_tapestry(const std::filesystem::path& directory);

/// The folder of a film's tapestry. @param path  the film's path in its record
std::filesystem::path tapestry_folder(const std::filesystem::path& state, const std::string& path);

/// Replaces the index by write, fsync and rename. @throws std::system_error
void write_tapestry(const std::filesystem::path& directory, const Tapestry& tapestry);

}  // namespace vitrine
