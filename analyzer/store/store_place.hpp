#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// Bytes that the store leaves free on its disk, for the catalogue and everyone else.
constexpr std::uint64_t least_free_bytes = 64U << 20;

/// Where the store is and what may be put there for one file.
struct StorePlace {
    std::filesystem::path store;
    std::string id;                // of the file, see store_id()
    int clip_side = 640;           // px, longest side of a clip
    std::uint64_t most_bytes = 0;  // of one clip or copy
    std::uint64_t least_free = 0;  // bytes that the disk must keep free
    bool wants_sound = false;      // of a film
};

/// Whether the disk has more free than it must keep.
bool has_room(const StorePlace& place);

}  // namespace vitrine::analyzer
