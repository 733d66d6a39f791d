#include "player/playback/photo_load.hpp"

#include "base/media/still_picture.hpp"

#include <exception>
#include <memory>
#include <span>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t pixel_bytes = 4;

void swap_red_and_blue(std::span<std::byte> pixels) {
    for (std::size_t i = 0; i + pixel_bytes <= pixels.size(); i += pixel_bytes)
        std::swap(pixels[i], pixels[i + 2]);
}

}  // namespace

Sample load_photo(const PhotoWish& wish) {
    const auto picture =
        std::make_shared<StillPicture>(load_still(wish.file, wish.width, wish.height, wish.background));
    swap_red_and_blue(picture->pixels);
    return {.width = picture->width,
            .height = picture->height,
            .stride = pixel_bytes * static_cast<std::size_t>(picture->width),
            .pixels = picture->pixels,
            .layout = PixelLayout::bgra,
            .owner = picture};
}

PhotoLoad::PhotoLoad(PhotoWish wish, SampleQueue& queue)
    : queue_(queue), thread_([this, wish = std::move(wish)] { run(wish); }) {}

PhotoLoad::~PhotoLoad() {
    thread_.join();
}

std::optional<std::string> PhotoLoad::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void PhotoLoad::run(const PhotoWish& wish) {
    try {
        queue_.put({.sample = load_photo(wish)});
    } catch (const std::exception& error) {
        {
            const std::lock_guard lock(mutex_);
            failure_ = error.what();
        }
        queue_.close();
    }
    has_ended_ = true;
}

}  // namespace vitrine::player
