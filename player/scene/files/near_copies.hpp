#pragma once

#include "base/state/record.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vitrine::player {

/// The relation of two photos by time and name.
enum class Kinship {
    strangers,   // taken at times that are too far apart: two pictures, however alike
    unknown,     // a camera wrote no time, and the files are about as old
    neighbours,  // taken within minutes
    sequence,    // taken within seconds
    copies,      // one has the name of the other, or both were taken at the same moment
};

/// The facts of a photo that tell its kinship, ready to be compared with those of many others.
struct PhotoFacts {
    std::string_view folder;
    std::string_view stem;
    std::optional<std::chrono::milliseconds> taken;  // since 1970
    bool has_camera_time = false;                    // else it is the file's own time
};

/// @param record  outlives the result
PhotoFacts facts_of(const MediaRecord& record);

Kinship kinship(const PhotoFacts& a, const PhotoFacts& b);

/// The limits of near-copies.
struct CopyLimits {
    double min_likeness = 2;  // correlation of their shades where they overlap best; above 1: they are none
    int max_hash_distance = -1;  // bits of 64
};

CopyLimits copy_limits(Kinship kinship);

/// Hashes of a photo and of parts of it. They find the photos that a photo could be a copy of.
struct PhotoHashes {
    std::uint64_t whole = 0;               // of its look
    std::array<std::uint64_t, 5> parts{};  // seven eighths of its sides: in the middle and at the corners
};

/// @pre the shot has a print and a look
PhotoHashes hashes_of(const Shot& shot);

/// The bits in which two photos differ. A crop is compared with the parts of the whole photo.
int distance_between(const PhotoHashes& a, const PhotoHashes& b);

/// False where colours tell at once that two photos are no copies. @pre both shots have a look
bool may_be_copies(const Shot& a, const Shot& b, Kinship kinship);

/// True for two photos that show one take: frames of a burst, copies, crops and other exposures.
bool are_near_copies(const MediaRecord& a, const MediaRecord& b);

/// True for a photo and the film that belongs to it as a Live Photo: both have one content identifier; or
/// they have one name but for its ending, were taken at the same time, and the film is a few seconds long.
bool are_live_pair(const MediaRecord& photo, const MediaRecord& film);

/// A file's name without folder and ending: of "a/IMG_1.HEIC" it is "IMG_1".
std::string_view stem_of(std::string_view path);

}  // namespace vitrine::player
