#include "analyzer/store/stored_copy.hpp"

#include "base/media/media_type.hpp"
#include "base/media/still_picture.hpp"
#include "base/state/media_error.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <system_error>

namespace vitrine::analyzer {

namespace {

namespace fs = std::filesystem;

constexpr int photo_side = 2880;                  // px: one and a half times a screen of 1920 px
constexpr std::uintmax_t small_photo = 3U << 20;  // bytes

/// Makes the file with `write`, which gets the name to write to, unless the file exists or there is no room.
template <typename Write>
std::optional<StoredShot> stored(StoredShot place_of, const StorePlace& place, const Write& write) {
    const fs::path file = place.store / place_of.file;
    std::error_code ignored;
    bool is_readable = true;
    try {
        fs::create_directories(file.parent_path());
        if (fs::exists(file) || !has_room(place)) return place_of;
        write(unfinished(file));
        if (fs::file_size(unfinished(file)) <= place.max_bytes)
            publish_file(unfinished(file), file);
        else
            place_of.is_dropped = true;
    } catch (const std::system_error& error) {  // a full disk is no reason not to show it
        log::debug("'{}' is not stored: {}", place_of.file, error.what());
    } catch (const MediaError& error) {
        log::debug("'{}' is not stored: {}", place_of.file, error.what());
        is_readable = !has_room(place);
    }
    fs::remove(unfinished(file), ignored);
    return is_readable ? std::optional(std::move(place_of)) : std::nullopt;
}

/// Copies what a file holds. Its mode is left out: whoever may read the store may read the copy, and a reader
/// in the sandbox cannot change a mode.
void copy_content(const std::string& from, const fs::path& to) {
    std::ifstream in(from, std::ios::binary);
    std::ofstream out(to, std::ios::binary);
    out << in.rdbuf();
    out.close();
    if (!in || !out)
        throw std::system_error(std::make_error_code(std::errc::io_error), fmt::format("copy '{}'", from));
}

std::optional<StoredShot> copied(const std::string& file, StoredShot place_of, const StorePlace& place) {
    return stored(std::move(place_of), place, [&](const fs::path& to) { copy_content(file, to); });
}

}  // namespace

std::optional<StoredShot> store_photo(const std::string& file, const MediaInfo& size,
                                      const StorePlace& place) {
    const int longest = std::max(size.width, size.height);
    std::error_code unknown;  // counts as too large
    const bool is_small = longest <= photo_side && fs::file_size(file, unknown) <= small_photo;
    StoredShot place_of{.file = place.id + "/photo", .width = size.width, .height = size.height};
    if (is_small && is_fast_to_decode(media_format(file))) return copied(file, std::move(place_of), place);
    const double scale = std::min(1.0, static_cast<double>(photo_side) / longest);
    place_of.width = std::max(1, static_cast<int>(std::lround(size.width * scale)));
    place_of.height = std::max(1, static_cast<int>(std::lround(size.height * scale)));
    return stored(std::move(place_of), place,
                  [&](const fs::path& to) { save_smaller(file, photo_side, to.string()); });
}

std::optional<StoredShot> store_film(const std::string& file, const MediaInfo& size,
                                     const StorePlace& place) {
    StoredShot place_of{.file = place.id + "/film", .width = size.width, .height = size.height};
    std::error_code unknown;  // counts as too large
    place_of.is_dropped = fs::file_size(file, unknown) > place.max_bytes;
    if (place_of.is_dropped) return place_of;
    return copied(file, std::move(place_of), place);
}

}  // namespace vitrine::analyzer
