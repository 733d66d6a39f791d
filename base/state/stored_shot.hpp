#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace vitrine {

/// A shot in the store, independent of changes in the media folder: a clip made for playing, or a copy of the
/// file.
struct StoredShot {
    std::string file;                   // in the store: ID/NAME
    std::chrono::nanoseconds begin{0};  // time of the shot in that file; 0 in a clip
    int width = 0;                      // px of its upright pictures, square pixels
    int height = 0;
    bool is_dropped = false;  // it was removed to make room for others, or was too large

    bool operator==(const StoredShot&) const = default;
};

/// The sound of a film in the store, with the times of the film.
struct StoredSound {
    std::string file;         // in the store: ID/NAME; empty: the film has no sound that can be played
    bool is_dropped = false;  // it was removed to make room for others, or was too large

    bool operator==(const StoredSound&) const = default;
};

/// The name of the folder in the store for one content of one file: a name_hash().
/// @param path  the path in the record
std::string store_id(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns);

/// True if this is the name of a file in the store, and of no file elsewhere: an ID, a slash, letters,
/// digits, '-' and single dots.
bool is_store_name(std::string_view file);

}  // namespace vitrine
