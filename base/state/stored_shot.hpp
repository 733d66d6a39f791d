#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace vitrine {

/// Where the analyzer keeps a shot apart from the media folder, so that nothing that happens there disturbs
/// it: a clip of it made for playing, or a copy of its file.
struct StoredShot {
    std::string file;                   // in the store: ID/NAME
    std::chrono::nanoseconds begin{0};  // of the shot in that file; 0 in a clip
    int width = 0;                      // px of its pictures: upright, square pixels
    int height = 0;
    bool is_dropped = false;  // it lost its place to others, or was too large for one

    friend bool operator==(const StoredShot&, const StoredShot&) = default;
};

/// Where the analyzer keeps the sound of a film that is to be heard, its times those of the film.
struct StoredSound {
    std::string file;         // in the store: ID/NAME; empty: the film has none that can be heard
    bool is_dropped = false;  // it lost its place to others, or was too large for one

    friend bool operator==(const StoredSound&, const StoredSound&) = default;
};

/// The folder of the store that holds one content of one file: 16 hex digits.
/// @param path  in the record
std::string store_id(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns);

/// Whether this names a file of the store, and cannot name any other: an ID, a slash, letters, digits, '-'
/// and single dots.
bool is_store_name(std::string_view file);

}  // namespace vitrine
