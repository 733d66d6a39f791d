#include "player/display/picture.hpp"

#include "base/media/still_picture.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/handle.hpp"

#include <fmt/format.h>
#include <vips/vips.h>

#include <atomic>
#include <stdexcept>

namespace vitrine::player {

namespace {

// g_object_unref takes a void pointer; the handle's type stays that of the image.
void unref_image(VipsImage* image) {
    g_object_unref(image);
}

using ImageHandle = Handle<VipsImage, &unref_image>;

[[noreturn]] void throw_vips(const std::filesystem::path& path) {
    std::string reason = vips_error_buffer();
    vips_error_clear();
    while (!reason.empty() && reason.back() == '\n')
        reason.pop_back();
    throw std::runtime_error(fmt::format("write picture '{}': {}", path.string(), reason));
}

}  // namespace

CardPicture::CardPicture(int its_width, int its_height)
    : width(its_width),
      height(its_height),
      pixels(std::make_shared_for_overwrite<std::byte[]>(static_cast<std::size_t>(width) *
                                                         static_cast<std::size_t>(height) * 4)) {}

std::span<std::byte> CardPicture::row(int y) const {
    const std::size_t bytes = static_cast<std::size_t>(width) * 4;
    return {&pixels[static_cast<std::size_t>(y) * bytes], bytes};
}

CardPicture CardPictureMemory::next(int width, int height) {
    if (last_.width != width || last_.height != height || last_.pixels.use_count() > 1)
        last_ = CardPicture(width, height);
    std::atomic_thread_fence(std::memory_order_acquire);  // after another thread's last use
    return last_;
}

Picture to_picture(const CardPicture& card) {
    Picture picture{.width = card.width, .height = card.height, .pixels = {}};
    picture.pixels.resize(static_cast<std::size_t>(card.width) * static_cast<std::size_t>(card.height) * 4);
    auto to = picture.pixels.begin();
    for (int y = 0; y < card.height; ++y) {
        const std::span<const std::byte> row = card.row(card.is_bottom_first ? card.height - 1 - y : y);
        for (std::size_t i = 0; i < row.size(); i += 4, to += 4) {
            to[0] = row[i + 2];
            to[1] = row[i + 1];
            to[2] = row[i];
            to[3] = std::byte{255};
        }
    }
    return picture;
}

namespace {

/// The picture without its alpha.
ImageHandle colours(const Picture& picture, const std::filesystem::path& path) {
    init_vips();

    const ImageHandle whole(vips_image_new_from_memory(picture.pixels.data(), picture.pixels.size(),
                                                       picture.width, picture.height, 4, VIPS_FORMAT_UCHAR));
    if (!whole) throw_vips(path);

    VipsImage* colour = nullptr;
    if (vips_extract_band(whole.get(), &colour, 0, "n", 3, nullptr) != 0) throw_vips(path);
    const ImageHandle owned(colour);
    if (vips_copy(owned.get(), &colour, "interpretation", VIPS_INTERPRETATION_sRGB, nullptr) != 0)
        throw_vips(path);
    return ImageHandle(colour);
}

}  // namespace

void save_png(const Picture& picture, const std::filesystem::path& path) {
    const ImageHandle image = colours(picture, path);
    if (vips_pngsave(image.get(), path.c_str(), "compression", 3, nullptr) != 0) throw_vips(path);
}

void save_jpeg(const Picture& picture, const std::filesystem::path& path) {
    constexpr int quality = 80;
    const ImageHandle image = colours(picture, path);
    const std::filesystem::path beside = unfinished(path);
    if (vips_jpegsave(image.get(), beside.c_str(), "Q", quality, "strip", TRUE, nullptr) != 0) {
        std::error_code ignored;
        std::filesystem::remove(beside, ignored);
        throw_vips(path);
    }
    publish_file(beside, path);
}

Picture drawn_svg(const std::string& svg, int width, int height) {
    const std::filesystem::path name = "drawing";
    init_vips();
    VipsImage* made = nullptr;
    if (vips_thumbnail_buffer(const_cast<char*>(svg.data()), svg.size(), &made, width, "height", height,
                              "size", VIPS_SIZE_FORCE, nullptr) != 0)
        throw_vips(name);
    const ImageHandle drawn(made);
    if (vips_cast(drawn.get(), &made, VIPS_FORMAT_UCHAR, nullptr) != 0) throw_vips(name);
    const ImageHandle bytes(made);
    Picture picture{.width = width, .height = height};
    std::size_t size = 0;
    void* pixels = vips_image_write_to_memory(bytes.get(), &size);
    if (pixels == nullptr) throw_vips(name);
    const auto* first = static_cast<const std::byte*>(pixels);
    picture.pixels.assign(first, first + size);
    g_free(pixels);
    picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4,
                          std::byte{255});
    return picture;
}

}  // namespace vitrine::player
