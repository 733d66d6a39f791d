#include "player/playback/shot_source.hpp"

#include "player/playback/film_loop.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t most_pictures = 12;  // decoded ahead; they bridge 400 ms of a film of 30 a second
constexpr std::size_t least_pictures = 4;
constexpr std::size_t most_bytes = 24U << 20;  // of pictures decoded ahead
constexpr std::chrono::nanoseconds rounding = std::chrono::milliseconds(1);
constexpr std::chrono::nanoseconds most_behind = std::chrono::milliseconds(250);  // before time gives way
constexpr std::chrono::nanoseconds hopeless = std::chrono::seconds(1);            // behind: it is sent ahead
constexpr std::chrono::nanoseconds jump_time =
    std::chrono::milliseconds(300);  // until a film plays elsewhere
constexpr std::chrono::nanoseconds between_jumps = std::chrono::seconds(3);

std::size_t capacity(const ShotRequest& request) {
    const std::size_t bytes = std::size_t{4} * static_cast<std::size_t>(std::max(1, request.width)) *
                              static_cast<std::size_t>(std::max(1, request.height));
    return std::clamp(most_bytes / bytes, least_pictures, most_pictures);
}

}  // namespace

ShotSource::ShotSource(std::string file, const ShotRequest& request, const SourceOptions& options,
                       std::chrono::nanoseconds at)
    : file_(std::move(file)),
      request_(request),
      options_(options),
      queue_(capacity(request)),
      judged_(at - std::chrono::nanoseconds(1)),
      jumped_(at) {
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
    return current_ ? std::nullopt : photo_->failure();  // a photo once read stays good
}

std::optional<Sample> ShotSource::frame_at(std::chrono::nanoseconds local) {
    has_news_ = false;
    if (detail_ != Detail::still) take_due(local - behind_);
    if (!current_) return std::nullopt;
    if (film_ && detail_ != Detail::still && local != judged_) judge_lateness(local);
    return current_->sample;
}

bool ShotSource::wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    if (is_outdated()) read_anew();
    while (true) {
        take_due(local - behind_);
        if (current_ && (photo_ ? !is_photo_coming_ : !queue_.is_empty()))
            return true;  // the rest is not due
        const auto left = deadline - std::chrono::steady_clock::now();
        if (left.count() <= 0 || !queue_.wait(left)) return false;
    }
}

Vec2 ShotSource::slide() const {
    if (!film_ || !current_) return {};
    const auto passed = current_->sample.stream_time - request_.shot.begin;
    const auto in_shot = std::clamp(passed, std::chrono::nanoseconds(0), request_.shot.duration());
    return request_.shot.region.drift * std::chrono::duration<double>(in_shot).count();
}

void ShotSource::resize(int width, int height) {
    request_.width = width;
    request_.height = height;
    if (film_) film_->resize(width, height);
}

void ShotSource::read_anew() {
    assert(is_outdated());
    read_photo();
}

void ShotSource::read_photo() {
    read_width_ = request_.width;
    read_height_ = request_.height;
    is_photo_coming_ = true;
    photo_ = std::make_unique<PhotoLoad>(file_, read_width_, read_height_, options_.background, queue_);
}

void ShotSource::set_detail(Detail detail) {
    if (!film_ || detail == detail_) return;
    detail_ = detail;
    jumped_ = judged_;
    film_->go_on(detail, judged_ + jump_time);
}

void ShotSource::stop() {
    queue_.close();
    if (film_) film_->stop();
}

bool ShotSource::has_ended() const {
    return film_ ? film_->has_ended() : photo_->has_ended();
}

/// When a picture is due, since the shot began to be shown.
std::chrono::nanoseconds ShotSource::position(const LoopedSample& sample) const {
    if (!film_) return std::chrono::nanoseconds(0);
    const auto loops = static_cast<std::chrono::nanoseconds::rep>(sample.loop);
    return request_.shot.duration() * loops + sample.sample.stream_time - request_.shot.begin;
}

void ShotSource::take_due(std::chrono::nanoseconds target) {
    while (auto sample = queue_.take_if(
               [&](const LoopedSample& next) { return !current_ || position(next) <= target + rounding; })) {
        current_ = std::move(sample);
        is_photo_coming_ = false;
        has_news_ = true;
    }
}

void ShotSource::judge_lateness(std::chrono::nanoseconds local) {
    judged_ = local;
    ++due_;
    if (!queue_.is_empty() || queue_.is_closed()) return;
    const std::chrono::nanoseconds missing = local - behind_ - position(*current_) - current_->duration;
    if (missing <= rounding) return;
    ++late_;
    if (!options_.keeps_time) {
        if (missing > most_behind) behind_ += missing;
    } else if (missing > hopeless && local - jumped_ > between_jumps) {
        jumped_ = local;
        film_->go_on(detail_, local + jump_time);
    }
}

}  // namespace vitrine::player
