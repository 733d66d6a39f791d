#include "analyzer/store/stored_copy.hpp"

#include "base/media/still_picture.hpp"
#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <vips/vips.h>

#include <cstdlib>
#include <limits>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

/// A photo of one colour, half transparent where it has four bands.
std::string write_photo(const fs::path& path, int width, int height, int bands) {
    REQUIRE(vips_init("test") == 0);
    std::vector<unsigned char> pixels;
    for (int i = 0; i < width * height; ++i) {
        pixels.insert(pixels.end(), {200, 40, 40});
        if (bands == 4) pixels.push_back(128);
    }
    VipsImage* image = vips_image_new_from_memory_copy(pixels.data(), pixels.size(), width, height, bands,
                                                       VIPS_FORMAT_UCHAR);
    image->Type = VIPS_INTERPRETATION_sRGB;
    REQUIRE(vips_image_write_to_file(image, path.c_str(), nullptr) == 0);
    g_object_unref(image);
    return path.string();
}

struct Shelf {
    std::optional<StoredShot> photo(const std::string& file, int width, int height) const {
        return store_photo(file, {.kind = MediaKind::photo, .width = width, .height = height}, place);
    }

    fs::path folder() const { return place.store / place.id; }

    TemporaryDirectory home;
    StorePlace place{.store = home.path / "store", .id = std::string(16, 'a'), .max_bytes = 1U << 20};
};

int red_over(const fs::path& photo, Colour background) {
    return static_cast<int>(load_still(photo.string(), 8, 8, background).pixels.at(0));
}

constexpr Colour black{};
constexpr Colour white{.red = 255, .green = 255, .blue = 255};

}  // namespace

TEST_CASE("a small photo is stored byte for byte") {
    const Shelf shelf;
    const std::string file = write_photo(shelf.home.path / "a.png", 60, 40, 3);
    const auto stored = shelf.photo(file, 60, 40);
    REQUIRE(stored);
    CHECK(*stored == StoredShot{.file = shelf.place.id + "/photo", .width = 60, .height = 40});
    CHECK(read_file(shelf.place.store / stored->file) == read_file(file));
}

TEST_CASE("a copy can be read by whoever may read the store, whatever mode the photo has") {
    const Shelf shelf;
    const std::string file = write_photo(shelf.home.path / "a.png", 60, 40, 3);
    fs::permissions(file, fs::perms::owner_read);
    REQUIRE(shelf.photo(file, 60, 40));
    const fs::perms usual = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
    CHECK((fs::status(shelf.folder() / "photo").permissions() & usual) == usual);
}

TEST_CASE("a large photo is stored smaller, and stays as transparent as it was") {
    const Shelf shelf;
    const std::string file = write_photo(shelf.home.path / "a.png", 5760, 40, 4);
    const auto stored = shelf.photo(file, 5760, 40);
    REQUIRE(stored);
    CHECK(stored->width == 2880);
    CHECK(stored->height == 20);
    const fs::path copy = shelf.place.store / stored->file;
    const StillPicture picture = load_still(copy.string(), 9999, 9999);
    CHECK(picture.full.width == 2880);
    CHECK(picture.full.height == 20);
    CHECK(std::abs(red_over(copy, black) - red_over(file, black)) <= 4);
    CHECK(std::abs(red_over(copy, white) - red_over(file, white)) <= 4);
    CHECK(red_over(copy, white) > red_over(copy, black) + 50);
}

TEST_CASE("a copy beyond its bytes is given up, one without room has its place all the same") {
    Shelf shelf;
    const std::string file = write_photo(shelf.home.path / "a.png", 60, 40, 3);
    shelf.place.max_bytes = 10;
    CHECK(shelf.photo(file, 60, 40)->is_dropped);
    CHECK(fs::is_empty(shelf.folder()));
    shelf.place.max_bytes = 1U << 20;
    shelf.place.min_free_bytes = std::numeric_limits<std::uint64_t>::max();
    CHECK_FALSE(shelf.photo(file, 60, 40)->is_dropped);
    CHECK(fs::is_empty(shelf.folder()));
}

TEST_CASE("what has gone meanwhile is stored nowhere") {
    const Shelf shelf;
    CHECK_FALSE(shelf.photo(shelf.home.path / "gone.png", 60, 40));
    const MediaInfo film{.kind = MediaKind::film, .width = 64, .height = 48};
    CHECK(store_film(shelf.home.path / "gone.mp4", film, shelf.place)->is_dropped);
}
