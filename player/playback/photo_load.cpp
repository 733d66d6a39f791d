#include "player/playback/photo_load.hpp"

#include "base/media/still_picture.hpp"

#include <exception>
#include <memory>
#include <utility>

namespace vitrine {

namespace {

Sample read(const std::string& file, int width, int height, Colour background) {
    const auto picture = std::make_shared<const StillPicture>(load_still(file, width, height, background));
    return {.width = picture->width,
            .height = picture->height,
            .stride = std::size_t{4} * static_cast<std::size_t>(picture->width),
            .pixels = picture->pixels,
            .owner = picture};
}

}  // namespace

PhotoLoad::PhotoLoad(std::string file, int width, int height, Colour background, SampleQueue& queue)
    : queue_(queue), thread_([this, file = std::move(file), width, height, background] {
          run(file, width, height, background);
      }) {}

PhotoLoad::~PhotoLoad() {
    thread_.join();
}

std::optional<std::string> PhotoLoad::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void PhotoLoad::run(const std::string& file, int width, int height, Colour background) {
    try {
        queue_.put({.sample = read(file, width, height, background)});
    } catch (const std::exception& error) {
        {
            const std::lock_guard lock(mutex_);
            failure_ = error.what();
        }
        queue_.close();
    }
    has_ended_ = true;
}

}  // namespace vitrine
