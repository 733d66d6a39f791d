#include "player/playback/playing_shot.hpp"

#include "player/scene/shot_request.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_cost = 0.01;  // cores; a working film costs more
constexpr std::chrono::nanoseconds rebuild_time =
    std::chrono::milliseconds(300);  // a rebuilt film plays by then

/// The part of the screen that an item covers, in [0, 1].
double share_of_screen(const DrawItem& item, Vec2 canvas) {
    if (!item.cell) return 0;
    double area = 0;
    for (const auto& [a, b, c] : item.cell->triangles)
        area += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    return std::min(1.0, item.alpha * area / (canvas.x * canvas.y));
}

void tell_file(const PoolState& pool, const std::string& path, FileNews news) {
    if (pool.tell_file) pool.tell_file(path, news);
}

}  // namespace

PlayingShot::PlayingShot(ShotRequest request, PoolState& pool) : pool_(pool), request_(std::move(request)) {
    start(true, request_.at);
}

/// Prefers the copy in the store.
void PlayingShot::start(bool may_be_stored, std::chrono::nanoseconds at) {
    tell_file(pool_, request_.path, FileNews::opens);
    opened_ = std::chrono::steady_clock::now();
    const std::optional<ShotFile> stored = may_be_stored ? stored_file(request_, pool_.places) : std::nullopt;
    is_stored_ = stored.has_value();
    const ShotFile file = stored ? *stored : media_file(request_, pool_.places);
    SourceOptions options = pool_.options;
    if (!stored && options.uploads.make_film) options.make_film = options.uploads.make_film;
    if (!stored && options.uploads.make_photo) options.make_photo = options.uploads.make_photo;
    if (is_software_) options.film.decoders.clear();
    source_ = std::make_unique<ShotSource>(file.path, file.request, options, at);
    meter_.restart();
}

SourceState PlayingShot::state() const {
    return {.source = request_.source,
            .path = request_.path,
            .is_film = request_.kind == MediaKind::film,
            .detail = source_->detail(),
            .is_stored = is_stored_,
            .is_ready = is_told_ready_,
            .late = source_->counts().late};
}

bool PlayingShot::is_stuck() const {
    return is_preparing() && std::chrono::steady_clock::now() - opened_ > pool_.options.opening_patience;
}

void PlayingShot::change_request(const ShotRequest& request) {
    request_.width = request.width;
    request_.height = request.height;
    if (!is_stored_ && request.shot.stored != request_.shot.stored) {
        request_.shot.stored = request.shot.stored;
        handover_.allow();
    }
    const ShotRequest read = is_stored_ ? *stored_request(request_) : request_;
    source_->resize(read.width, read.height);
    handover_.resize(request.width, request.height);
}

void PlayingShot::collect_events(std::vector<SourceEvent>& events) {
    if (!is_told_ready_ && source_->is_ready()) {
        is_told_ready_ = true;
        events.push_back({.source = request_.source, .unstored = is_stored_ ? "" : request_.path});
    }
    if (is_told_failed_) return;
    std::optional<std::string> failure = given_up_ ? given_up_ : source_->failure();
    if (!failure) return;
    const bool may_be_damaged = is_stored_ && !is_told_ready_;  // the file itself may be undamaged
    const bool may_use_hardware = is_stored_ || !pool_.options.uploads.make_film;
    const bool may_be_decoder =
        !is_software_ && may_use_hardware && !pool_.options.film.decoders.empty() && !given_up_;
    if (may_be_damaged || may_be_decoder) {
        if (!may_be_damaged) is_software_ = true;
        pool_.ending.push_back(std::move(source_));
        return start(is_stored_ && !may_be_damaged, {});
    }
    is_told_failed_ = true;
    if (source_->has_crashed()) tell_file(pool_, request_.path, FileNews::crashed_its_reader);
    events.push_back({.source = request_.source, .failure = std::move(failure)});
}

void PlayingShot::advance(const DrawItem& item, const Frame& frame) {
    local_ = item.local;
    if (handover_.is_due(local_)) take_clip();
    if (std::optional<Sample> sample = source_->picture_at(local_)) sample_ = std::move(sample);
    if (!pool_.options.keeps_time) return;
    meter_.note_shown(share_of_screen(item, frame.canvas), frame.time);
    watch(frame.time);
}

bool PlayingShot::wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience) {
    if (source_->failure()) return true;
    const auto deadline = std::chrono::steady_clock::now() + patience;
    if (handover_.is_due(local)) handover_.wait_until_ready(patience);
    return source_->wait_for(local, deadline - std::chrono::steady_clock::now());
}

bool PlayingShot::is_clip_wanted() const {
    return handover_.is_allowed() && request_.kind == MediaKind::film && is_told_ready_ && !given_up_;
}

void PlayingShot::open_clip() {
    handover_.open_clip(request_, pool_.places, pool_.options, local_);
}

/// Changes to the clip at its seam if the clip is ready; else the film goes on from the media folder.
void PlayingShot::take_clip() {
    std::unique_ptr<ShotSource> clip = handover_.take_clip();
    const bool is_ready = clip->is_ready() && !given_up_;
    if (is_ready) {
        pool_.late += source_->counts().late;
        clip->set_detail(source_->detail());
        is_stored_ = true;
        handover_.forbid();
        meter_.restart();
        std::swap(source_, clip);
    }
    clip->stop();
    pool_.ending.push_back(std::move(clip));
}

void PlayingShot::watch(std::chrono::nanoseconds now) {
    if (!is_told_ready_ || given_up_) return;
    switch (watchdog_.judge(source_->is_starved(), now)) {
    case Watchdog::Verdict::fine:
        return;
    case Watchdog::Verdict::rebuild_in_software:
        is_software_ = true;
        return rebuild();
    case Watchdog::Verdict::rebuild:
        return rebuild();
    case Watchdog::Verdict::give_up:
        source_->stop();
        given_up_ = "the film stopped several times while it played";
        return;
    }
}

/// Replaces the source. The last picture is shown until the new source has one.
void PlayingShot::rebuild() {
    pool_.late += source_->counts().late;
    const Detail detail = source_->detail();
    source_->stop();
    pool_.ending.push_back(std::move(source_));
    start(is_stored_, local_ + rebuild_time);
    source_->set_detail(detail);
}

std::optional<FilmLoad> PlayingShot::measure_load(std::chrono::nanoseconds since,
                                                  std::chrono::nanoseconds now) {
    const bool plays = is_told_ready_ && !given_up_ && meter_.was_shown_after(since);
    if (request_.kind == MediaKind::photo || !plays) return std::nullopt;
    const FilmLoad load = meter_.measure(request_.source, source_->counts(), now - since);
    if (source_->is_starved() && load.cost < min_cost) return std::nullopt;  // left to the watchdog
    return load;
}

void PlayingShot::retire() {
    pool_.late += source_->counts().late;
    source_->stop();
    pool_.ending.push_back(std::move(source_));
    if (std::unique_ptr<ShotSource> clip = handover_.take_clip()) {
        clip->stop();
        pool_.ending.push_back(std::move(clip));
    }
}

}  // namespace vitrine::player
