#include "player/playback/photo_load.hpp"

#include <exception>
#include <utility>

namespace vitrine {

PhotoLoad::PhotoLoad(std::string file, int width, int height, SampleQueue& queue)
    : queue_(queue), thread_([this, file = std::move(file), width, height] { run(file, width, height); }) {}

PhotoLoad::~PhotoLoad() {
    thread_.join();
}

std::optional<std::string> PhotoLoad::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void PhotoLoad::run(const std::string& file, int width, int height) {
    (void)file;
    (void)width;
    (void)height;
    {
        const std::lock_guard lock(mutex_);
        failure_ = "photos are not read yet";
    }
    queue_.close();
    has_ended_ = true;
}

}  // namespace vitrine
