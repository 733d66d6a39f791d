#include "base/media/still_picture.hpp"

#include "base/state/media_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>
#include <vips/vips.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>

using namespace vitrine;

namespace {

struct TempFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("vitrine-still-{}", ::getpid());

    TempFolder() { std::filesystem::create_directories(path); }

    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    ~TempFolder() { std::filesystem::remove_all(path); }

    std::string operator/(const char* name) const { return path / name; }
};

using Pixel = std::array<int, 3>;

constexpr Pixel red{220, 30, 30};
constexpr Pixel green{30, 180, 40};
constexpr Pixel blue{30, 40, 220};
constexpr Pixel yellow{230, 220, 40};

// Four coloured quarters: upper left red, upper right green, lower left blue, lower right yellow.
std::vector<unsigned char> quarters(int width, int height, int alpha) {
    std::vector<unsigned char> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Pixel& colour =
                y < height / 2 ? (x < width / 2 ? red : green) : (x < width / 2 ? blue : yellow);
            for (const int value : colour)
                pixels.push_back(static_cast<unsigned char>(value));
            if (alpha >= 0) pixels.push_back(static_cast<unsigned char>(alpha));
        }
    return pixels;
}

void write(const std::string& path, int width, int height, int alpha = -1, int orientation = 0) {
    REQUIRE(vips_init("test") == 0);
    const auto pixels = quarters(width, height, alpha);
    VipsImage* image = vips_image_new_from_memory_copy(pixels.data(), pixels.size(), width, height,
                                                       alpha < 0 ? 3 : 4, VIPS_FORMAT_UCHAR);
    REQUIRE(image);
    image->Type = VIPS_INTERPRETATION_sRGB;
    if (orientation > 0) vips_image_set_int(image, VIPS_META_ORIENTATION, orientation);
    REQUIRE(vips_image_write_to_file(image, path.c_str(), nullptr) == 0);
    g_object_unref(image);
}

bool is_near(const StillPicture& picture, double x, double y, const Pixel& colour) {
    const auto column = static_cast<std::size_t>(x * picture.width);
    const auto row = static_cast<std::size_t>(y * picture.height);
    const std::size_t at = 4 * (row * static_cast<std::size_t>(picture.width) + column);
    constexpr int tolerance = 24;  // JPEG
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(std::to_integer<int>(picture.pixels[at + i]) - colour[i]) > tolerance) return false;
    return picture.pixels[at + 3] == std::byte{255};
}

bool is_upright(const StillPicture& picture) {
    return is_near(picture, 0.2, 0.2, red) && is_near(picture, 0.8, 0.2, green) &&
           is_near(picture, 0.2, 0.8, blue) && is_near(picture, 0.8, 0.8, yellow);
}

MediaState state_of(const std::string& path) {
    try {
        load_still(path, 100, 100);
    } catch (const MediaError& error) {
        return error.state();
    }
    return MediaState::ready;
}

std::string reason_of(const std::string& path) {
    try {
        load_still(path, 100, 100);
    } catch (const MediaError& error) {
        return error.what();
    }
    return "";
}

void cut(const std::string& path, double share) {
    std::filesystem::resize_file(
        path, static_cast<std::uintmax_t>(static_cast<double>(std::filesystem::file_size(path)) * share));
}

void append(std::string& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<char>(value >> (8 * i)));
}

// A 24-bit bitmap of the four quarters, rows from the bottom as usual.
std::string bitmap(int width, int height) {
    std::string bytes = "BM";
    bytes.append(8, '\0');
    append(bytes, 54, 4);
    append(bytes, 40, 4);
    append(bytes, static_cast<std::uint32_t>(width), 4);
    append(bytes, static_cast<std::uint32_t>(height), 4);
    append(bytes, 1, 2);
    append(bytes, 24, 2);
    bytes.append(24, '\0');
    const auto pixels = quarters(width, height, -1);
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x)
            for (int i = 2; i >= 0; --i)
                bytes.push_back(static_cast<char>(pixels[static_cast<std::size_t>(3 * (y * width + x) + i)]));
        bytes.append(static_cast<std::size_t>(width % 4), '\0');
    }
    return bytes;
}

}  // namespace

TEST_CASE("a PNG that says its orientation stands upright") {
    const TempFolder folder;
    const std::string path = folder / "photo.png";
    write(path, 60, 90, -1, 0);
    std::ifstream in(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    using namespace std::string_literals;
    // Orientation 6, in an eXIf chunk behind the header; its checksum is the last word. libvips writes none
    // itself.
    constexpr std::size_t header_end = 33;
    bytes.insert(header_end, "\0\0\0\x1a"
                             "eXIfMM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"
                             "\xd6\x67\x4b\x69"s);
    std::ofstream(path, std::ios::binary) << bytes;
    const StillPicture picture = load_still(path, 45, 45);
    CHECK(picture.full.width == 90);
    CHECK(is_near(picture, 0.2, 0.2, blue));
    CHECK(is_near(picture, 0.8, 0.2, red));
}

TEST_CASE("a photo of any orientation stands upright, whatever its format") {
    const TempFolder folder;
    // where the stored picture's quarters come from, by EXIF: each test undoes the writer's turn
    for (int i = 0; i < 24; ++i) {
        constexpr std::array names{"photo.jpg", "photo.webp", "photo.tif"};
        const std::string path = folder / names[static_cast<std::size_t>(i / 8)];
        const int orientation = i % 8 + 1;
        CAPTURE(path);
        CAPTURE(orientation);
        const bool turned = orientation >= 5;
        write(path, turned ? 60 : 90, turned ? 90 : 60, -1, orientation);
        const StillPicture picture = load_still(path, 45, 45);
        CHECK(picture.full.width == 90);
        CHECK(picture.full.height == 60);
        CHECK(picture.width == 45);
        CHECK(picture.height == 30);
        constexpr std::array<std::array<Pixel, 4>, 8> upright{{{red, green, blue, yellow},
                                                               {green, red, yellow, blue},
                                                               {yellow, blue, green, red},
                                                               {blue, yellow, red, green},
                                                               {red, blue, green, yellow},
                                                               {blue, red, yellow, green},
                                                               {yellow, green, blue, red},
                                                               {green, yellow, red, blue}}};
        const auto& expected = upright[static_cast<std::size_t>(orientation - 1)];
        CHECK(is_near(picture, 0.2, 0.2, expected[0]));
        CHECK(is_near(picture, 0.8, 0.2, expected[1]));
        CHECK(is_near(picture, 0.2, 0.8, expected[2]));
        CHECK(is_near(picture, 0.8, 0.8, expected[3]));
    }
}

TEST_CASE("a small photo is not enlarged") {
    const TempFolder folder;
    write(folder / "small.png", 40, 20);
    const StillPicture picture = load_still(folder / "small.png", 400, 400);
    CHECK(picture.width == 40);
    CHECK(picture.height == 20);
    CHECK(is_upright(picture));
}

TEST_CASE("a photo whose header says that it is enormous is refused before it is decoded") {
    const TempFolder folder;
    const std::string path = folder / "enormous.jpg";
    write(path, 80, 60);
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t frame = bytes.find("\xFF\xC0");
    REQUIRE(frame != std::string::npos);
    constexpr std::size_t height_at = 5;  // behind the marker, its length and the depth
    file.seekp(static_cast<std::streamoff>(frame + height_at));
    file.write("\x9C\x40\x9C\x40", 4);  // 40,000 px
    file.close();
    CHECK_THROWS_WITH_AS(load_still(path, 400, 400),
                         "the picture is too large: 40000 x 40000 px; up to 200 megapixels are shown",
                         MediaError);
}

TEST_CASE("the background shows through what is transparent") {
    const TempFolder folder;
    write(folder / "clear.png", 40, 20, 0);
    const StillPicture picture =
        load_still(folder / "clear.png", 40, 40, {.red = 10, .green = 200, .blue = 90});
    CHECK(is_near(picture, 0.5, 0.5, {10, 200, 90}));
}

TEST_CASE("every still format gives the same picture") {
    const TempFolder folder;
    for (const char* name : {"a.jpg", "a.png", "a.webp", "a.tif"}) {
        CAPTURE(name);
        write(folder / name, 80, 60);
        CHECK(is_upright(load_still(folder / name, 40, 40)));
    }
}

TEST_CASE("a file name that libvips or a shell would read is only a name") {
    const TempFolder folder;
    write(folder / "plain.jpg", 80, 60);
    for (const char* name : {"a[shrink=8].jpg", "%s%n.jpg", "-rf.jpg", "http:x.jpg"}) {
        std::filesystem::copy_file(folder / "plain.jpg", folder / name);
        CHECK(is_upright(load_still(folder / name, 80, 80)));
    }
}

TEST_CASE("a picture cut short is waited for, whatever its format") {
    const TempFolder folder;
    for (const char* name : {"a.jpg", "a.png", "a.webp", "a.tif"}) {
        for (const double share : {0.1, 0.5, 0.95}) {
            CAPTURE(name);
            CAPTURE(share);
            write(folder / name, 800, 600);
            cut(folder / name, share);
            CHECK(state_of(folder / name) == MediaState::waiting);
        }
    }
}

TEST_CASE("what follows the end of a picture does not matter") {
    const TempFolder folder;
    write(folder / "a.jpg", 80, 60);
    std::ofstream(folder / "a.jpg", std::ios::app | std::ios::binary) << std::string(20'000, 'x');
    CHECK(state_of(folder / "a.jpg") == MediaState::ready);
}

TEST_CASE("a bitmap is read, top down in the picture though bottom up in the file") {
    const TempFolder folder;
    const std::string path = folder / "a.bmp";
    std::ofstream(path, std::ios::binary) << bitmap(81, 60);
    CHECK(load_still(path, 40, 40).full.width == 81);
    CHECK(is_upright(load_still(path, 40, 40)));
    cut(path, 0.5);
    CHECK(state_of(path) == MediaState::waiting);
}

TEST_CASE("a bitmap that claims to be huge is refused by its header") {
    const TempFolder folder;
    const std::string path = folder / "a.bmp";
    std::ofstream(path, std::ios::binary) << bitmap(2, 2).replace(18, 4, "\xff\xff\xff\x7f", 4);
    CHECK(state_of(path) == MediaState::unsupported);
}

TEST_CASE("a picture that is all there but damaged is not waited for") {
    const TempFolder folder;
    // where each one's coded picture or first directory entry lies: the chunks' sizes stay as they are
    const std::array<std::pair<const char*, std::streamoff>, 3> damage{
        {{"a.webp", 30}, {"a.png", 70}, {"a.tif", -1}}};
    for (const auto& [file_name, at] : damage) {
        const char* name = file_name;
        CAPTURE(name);
        write(folder / name, 80, 60);
        std::fstream file(folder / name, std::ios::binary | std::ios::in | std::ios::out);
        std::uint32_t directory = 0;
        file.seekg(4);
        file.read(reinterpret_cast<char*>(&directory), 4);
        file.seekp(at < 0 ? std::streamoff{directory} + 2 + 8 : at);
        file << std::string(at < 0 ? 4 : 40, '\0');  // a TIFF whose width is none
        file.close();
        CHECK(state_of(folder / name) == MediaState::failed);
        CHECK(reason_of(folder / name) == "the picture is damaged");
    }
}
