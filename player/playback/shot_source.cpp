#include "player/playback/shot_source.hpp"

#include "player/playback/film_loop.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t max_pictures = 12;  // decoded ahead; they bridge 400 ms at 30 pictures a second
constexpr std::size_t min_pictures = 4;
constexpr std::size_t max_bytes = 24U << 20;  // memory of the pictures decoded ahead

std::size_t capacity(const ShotRequest& request) {
    const std::size_t bytes = std::size_t{4} * static_cast<std::size_t>(std::max(1, request.width)) *
                              static_cast<std::size_t>(std::max(1, request.height));
    return std::clamp(max_bytes / bytes, min_pictures, max_pictures);
}

}  // namespace

ShotSource::ShotSource(std::string file, const ShotRequest& request, const SourceOptions& options,
                       std::chrono::nanoseconds at)
    : file_(std::move(file)),
      request_(request),
      options_(options),
      queue_(capacity(request)),
      clock_(options.keeps_time, at) {
    if (request.kind == MediaKind::photo) {
        read_photo();
        return;
    }
    const FilmPart part{.file = file_,
                        .begin = request.shot.begin,
                        .end = request.shot.end,
                        .width = request.width,
                        .height = request.height,
                        .at = at};
    film_ = options.make_film ? options.make_film(part, queue_, options.film)
                              : std::make_unique<FilmLoop>(part, queue_, options.film);
}

std::optional<std::string> ShotSource::failure() const {
    if (film_) return film_->failure();
    return current_ ? std::nullopt : photo_->failure();  // a photo that was read once stays valid
}

std::optional<Sample> ShotSource::picture_at(std::chrono::nanoseconds local) {
    has_news_ = false;
    if (detail_ != Detail::still) take_due_pictures(clock_.target(local));
    if (!current_) return std::nullopt;
    if (film_ && detail_ != Detail::still) judge_lateness(local);
    return current_->sample;
}

bool ShotSource::wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    if (is_outdated()) read_photo();
    while (true) {
        take_due_pictures(clock_.target(local));
        if (current_ && (photo_ ? !is_photo_coming_ : !queue_.is_empty()))
            return true;  // the next picture is not due yet
        const auto left = deadline - std::chrono::steady_clock::now();
        if (left.count() <= 0 || !queue_.wait(left)) return false;
    }
}

/// The way of the subject since the shot's begin.
Vec2 ShotSource::slide_of(const Sample& sample) const {
    if (!film_) return {};
    const auto passed = sample.stream_time - request_.shot.begin;
    const auto in_shot = std::clamp(passed, std::chrono::nanoseconds(0), request_.shot.duration());
    return request_.shot.region.drift * std::chrono::duration<double>(in_shot).count();
}

void ShotSource::resize(int width, int height) {
    request_.width = width;
    request_.height = height;
    if (film_) film_->resize(width, height);
}

void ShotSource::read_photo() {
    assert(!film_ && (!photo_ || photo_->has_ended()));
    is_photo_coming_ = true;
    photo_width_ = request_.width;
    photo_height_ = request_.height;
    const PhotoWish wish{
        .file = file_, .width = photo_width_, .height = photo_height_, .background = options_.background};
    photo_ =
        options_.make_photo ? options_.make_photo(wish, queue_) : std::make_unique<PhotoLoad>(wish, queue_);
}

ShotCounts ShotSource::counts() const {
    ShotCounts counts = clock_.counts();
    if (film_) counts.spent = film_->spent();
    return counts;
}

void ShotSource::set_detail(Detail detail) {
    if (!film_ || detail == detail_) return;
    detail_ = detail;
    film_->play_from(detail, clock_.jump());
}

void ShotSource::stop() {
    queue_.close();
    if (film_) film_->stop();
    if (photo_) photo_->stop();
}

bool ShotSource::has_ended() const {
    return film_ ? film_->has_ended() : photo_->has_ended();
}

/// The place of a picture, in time over all loops.
std::chrono::nanoseconds ShotSource::position(const LoopedSample& sample) const {
    if (!film_) return std::chrono::nanoseconds(0);
    const auto loops = static_cast<std::chrono::nanoseconds::rep>(sample.loop);
    return request_.shot.duration() * loops + sample.sample.stream_time - request_.shot.begin;
}

void ShotSource::take_due_pictures(std::chrono::nanoseconds target) {
    const auto is_due = [&](const LoopedSample& next) {
        return !current_ || position(next) <= target + ShotClock::rounding;
    };
    while (auto sample = queue_.take_if(is_due)) {
        current_ = std::move(sample);
        current_->sample.slide = slide_of(current_->sample);
        is_photo_coming_ = false;
        has_news_ = true;
    }
}

void ShotSource::judge_lateness(std::chrono::nanoseconds local) {
    const bool has_next = !queue_.is_empty() || queue_.is_closed();
    const auto missing = clock_.target(local) - position(*current_) - current_->duration;
    if (clock_.judge(local, has_next ? std::chrono::nanoseconds(0) : missing))
        film_->play_from(detail_, clock_.jump());
}

}  // namespace vitrine::player
