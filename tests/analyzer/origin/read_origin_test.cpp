#include "analyzer/origin/read_origin.hpp"

#include "base/system/handle.hpp"
#include "tests/analyzer/origin/drawn_boxes.hpp"
#include "tests/analyzer/origin/drawn_exif.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <libheif/heif.h>

#include <cstdlib>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::sys_days day = std::chrono::year(2023) / 5 / 1;
constexpr std::chrono::sys_days now = std::chrono::year(2026) / 1 / 1;
constexpr std::chrono::sys_days copied = std::chrono::year(2025) / 1 / 1;

DrawnExif taken_at(const std::string& time) {
    return {.photo = {{0x9003, 2, time}, {0x9011, 2, "+02:00"}}};
}

MediaOrigin origin_of(const std::filesystem::path& file, std::chrono::sys_days own = copied) {
    return read_origin(file.string(), std::chrono::nanoseconds(own.time_since_epoch()).count(), now);
}

std::string png_with(const std::string& exif) {
    const auto chunk = [](const std::string& name, const std::string& content) {
        return big_bytes(content.size(), 4) + name + content + std::string(4, '\0');
    };
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", std::string(13, '\0')) + chunk("eXIf", exif) +
           chunk("IEND", "");
}

std::string webp_with(const std::string& exif) {
    const std::string chunks =
        "VP8X" + number_bytes(10, 4) + std::string(10, '\0') + "EXIF" + number_bytes(exif.size(), 4) + exif;
    return "RIFF" + number_bytes(chunks.size() + 4, 4) + "WEBP" + chunks;
}

void write_heif(const std::string& path, const std::string& exif) {
    const Handle<heif_context, &heif_context_free> context(heif_context_alloc());
    heif_encoder* encoder = nullptr;
    REQUIRE(heif_context_get_encoder_for_format(context.get(), heif_compression_AV1, &encoder).code == 0);
    const Handle<heif_encoder, &heif_encoder_release> held_encoder(encoder);
    heif_image* image = nullptr;
    REQUIRE(heif_image_create(64, 64, heif_colorspace_RGB, heif_chroma_interleaved_RGB, &image).code == 0);
    const Handle<heif_image, &heif_image_release> held_image(image);
    REQUIRE(heif_image_add_plane(image, heif_channel_interleaved, 64, 64, 24).code == 0);
    heif_image_handle* handle = nullptr;
    REQUIRE(heif_context_encode_image(context.get(), image, encoder, nullptr, &handle).code == 0);
    const Handle<heif_image_handle, &heif_image_handle_release> held_handle(handle);
    const std::string block = std::string("Exif\0\0", 6) + exif;
    REQUIRE(
        heif_context_add_exif_metadata(context.get(), handle, block.data(), static_cast<int>(block.size()))
            .code == 0);
    REQUIRE(heif_context_write_to_file(context.get(), path.c_str()).code == 0);
}

}  // namespace

TEST_CASE("the time is read from each format that has EXIF") {
    const TemporaryDirectory house;
    const std::string exif = taken_at("2023:05:01 12:30:05").bytes();
    write_heif((house.path / "a.heic").string(), exif);
    for (const auto& file : {house.write("a.jpg", jpeg_with(exif)), house.write("a.png", png_with(exif)),
                             house.write("a.webp", webp_with(exif)), house.path / "a.heic"}) {
        CAPTURE(file.string());
        const MediaOrigin origin = origin_of(file);
        REQUIRE(origin.taken);
        CHECK(origin.taken->at == day + 10h + 30min + 5s);
        CHECK(origin.taken->source == TimeSource::camera);
    }
}

TEST_CASE("a file without a time, and one whose camera had a wrong clock, has its own time") {
    const TemporaryDirectory house;
    for (const std::string& bytes :
         {std::string("\xff\xd8\xff\xda", 4), jpeg_with(taken_at("1980:01:01 00:00:00").bytes()),
          jpeg_with(taken_at("2031:01:01 00:00:00").bytes()), movie(movie_header(1000))}) {
        const MediaOrigin origin = origin_of(house.write("a", bytes));
        REQUIRE(origin.taken);
        CHECK(origin.taken->at == copied);
        CHECK(origin.taken->source == TimeSource::file);
    }
}

TEST_CASE("a file whose own time is wrong, too, has none") {
    const TemporaryDirectory house;
    const auto file = house.write("a.jpg", std::string("\xff\xd8\xff\xda", 4));
    CHECK_FALSE(origin_of(file, std::chrono::sys_days(std::chrono::year(1970) / 1 / 1)).taken);
    CHECK_FALSE(origin_of(file, std::chrono::sys_days(std::chrono::year(2040) / 1 / 1)).taken);
    CHECK_FALSE(
        origin_of(house.path / "gone.jpg", std::chrono::sys_days(std::chrono::year(1970) / 1 / 1)).taken);
}

TEST_CASE("the time of a photo shortly before now is plausible in every zone") {
    CHECK(is_plausible(now + 14h, now));
    CHECK_FALSE(is_plausible(now + 25h, now));
    CHECK_FALSE(is_plausible(std::chrono::sys_days(std::chrono::year(1989) / 12 / 31), now));
}
