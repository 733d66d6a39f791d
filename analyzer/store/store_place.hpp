#pragma once

#include "base/settings/settings.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// Bytes that the store leaves free on its disk, for the catalogue and everyone else.
constexpr std::uint64_t usual_free_bytes = 64U << 20;

/// The place of one medium in the store, and the limits there.
struct StorePlace {
    std::filesystem::path store;
    std::string id;                    // see store_id()
    int clip_side = 640;               // px, longest side of a clip
    std::uint64_t max_bytes = 0;       // for one clip or copy
    std::uint64_t min_free_bytes = 0;  // bytes that the disk must keep free
    bool wants_sound = false;          // films only
};

/// The longest side of the clips that are made for the store, px: as set, or as the screens need them.
int clip_side(const Settings& settings);

/// True where the disk has more free than it must keep.
bool has_room(const StorePlace& place);

}  // namespace vitrine::analyzer
