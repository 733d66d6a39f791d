#include "player/stage/wall_picture.hpp"

#include "base/system/log.hpp"
#include "player/display/memory_target.hpp"
#include "player/render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace vitrine::player {

using namespace std::chrono_literals;

namespace {

constexpr auto interval = 30s;     // between two pictures of the same shots
constexpr auto after_change = 2s;  // wait until a change of shots has ended
constexpr auto rest = 8s;          // between two pictures of any shots

bool write_jpeg(const Picture& picture, const std::filesystem::path& file) {
    try {
        save_jpeg(picture, file);
        return true;
    } catch (const std::exception& error) {  // no exception may leave a thread; the wall goes on
        log::debug("no picture of the wall: {}", error.what());
        return false;
    }
}

}  // namespace

Picture picture_of(const Frame& frame, int max_side, Renderer& renderer) {
    const double scale = max_side / std::max(frame.canvas.x, frame.canvas.y);
    const auto pixels = [&](double side) { return std::max(1, static_cast<int>(std::lround(side * scale))); };
    MemoryTarget target(pixels(frame.canvas.x), pixels(frame.canvas.y));
    target.make_current();
    renderer.aim(target.width(), target.height(),
                 letterboxed(target.width(), target.height(), {}, frame.canvas));
    renderer.draw(frame);
    return to_picture(target.picture());
}

bool WallPicture::is_due(const Frame& frame, std::chrono::nanoseconds now) {
    std::vector<SourceId> sources;
    for (const DrawItem& item : frame.items)
        sources.push_back(item.source);
    if (sources != sources_) {
        sources_ = std::move(sources);
        next_ = std::max(std::min(next_, now + after_change), earliest_);
    }
    if (now < next_) return false;
    next_ = now + interval;
    earliest_ = now + rest;
    return true;
}

void WallPicture::write(Picture picture) {
    if (written_.valid() && written_.wait_for(0s) != std::future_status::ready) return;
    if (written_.valid() && !written_.get() && !std::exchange(has_complained_, true))
        log::warning("the picture of the wall cannot be written: '{}'", file_.string());
    if (picture.pixels == pixels_) return;
    pixels_ = picture.pixels;
    written_ = std::async(std::launch::async, write_jpeg, std::move(picture), file_);
}

}  // namespace vitrine::player
