#include "player/scene/tapestry/tapestry_preview.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto span_above = 60s;    // longest part above the strip; then the next part follows
constexpr auto span_in_strip = 4s;  // longest part in place; then it repeats
constexpr auto min_span = 1s;       // shortest time to the end of the film or of a shot
constexpr auto preparing = 1500ms;  // the next span is requested so long before a span's end
constexpr nanoseconds at_next_frame{-1};

/// The shot that contains a time. A time between two shots gives the next shot; a time after the last shot
/// gives the last. nullptr: the shots are not known.
const Shot* shot_at(const std::vector<Shot>& shots, nanoseconds time) {
    if (shots.empty()) return nullptr;
    const auto found =
        std::ranges::upper_bound(shots, time, std::less<>(), [](const Shot& shot) { return shot.end; });
    return found == shots.end() ? &shots.back() : &*found;
}

}  // namespace

TapestryPreview::TapestryPreview(PreviewedFilm film, SourceId last_source)
    : film_(std::move(film)), last_source_(last_source) {}

void TapestryPreview::play(nanoseconds from, double width) {
    retire(next_above_);
    next_above_ = request({from, from + span_above}, width);
}

FilmSpan TapestryPreview::span_in_place(nanoseconds from) const {
    nanoseconds length = span_in_strip;
    if (const Shot* within = shot_at(film_.shots, from); within != nullptr) {
        length = std::min(length, within->duration());
        from = std::clamp(from, within->begin, within->end - length);
    }
    return {from, from + length};
}

void TapestryPreview::play_in_place(const FilmSpan& span, double width) {
    retire(in_place_);
    in_place_ = request(span, width);
}

void TapestryPreview::play_on(nanoseconds now, double width) {
    if (!above_ || !above_->began || above_->began->count() < 0) return;
    const nanoseconds left = *above_->began + above_->span.length() - now;
    const nanoseconds end = film_.shots.empty() ? film_.duration - min_span : film_.shots.back().end;
    if (left <= preparing && !next_above_ && above_->span.end < end) {
        next_above_ = request({above_->span.end, above_->span.end + span_above}, width);
        next_above_->continues = true;
    }
    if (left.count() > 0 || !next_above_ || !next_above_->continues || !next_above_->began) return;
    retire(above_);
    above_ = std::exchange(next_above_, std::nullopt);
    above_->continues = false;
}

void TapestryPreview::stop_preview() {
    retire(above_);
    if (next_above_ && next_above_->continues) retire(next_above_);
}

void TapestryPreview::stop_in_place() {
    retire(in_place_);
}

void TapestryPreview::stop_outdated() {
    retire(next_above_);
    retire(in_place_);
}

void TapestryPreview::stop_all() {
    retire(above_);
    stop_outdated();
}

void TapestryPreview::source_ready(SourceId source) {
    if (next_above_ && next_above_->source == source) {
        next_above_->began = at_next_frame;
        if (!next_above_->continues) {
            retire(above_);
            above_ = std::exchange(next_above_, std::nullopt);
        }
    }
    if (in_place_ && in_place_->source == source) in_place_->began = at_next_frame;
}

void TapestryPreview::source_failed(SourceId source) {
    for (std::optional<PlayingSpan>* playing : {&above_, &next_above_, &in_place_})
        if (*playing && (*playing)->source == source) retire(*playing);
}

void TapestryPreview::start_ready(nanoseconds now) {
    for (std::optional<PlayingSpan>* playing : {&above_, &in_place_})
        if (*playing && (*playing)->began && (*playing)->began->count() < 0) (*playing)->began = now;
}

nanoseconds TapestryPreview::time_above(nanoseconds now) const {
    const nanoseconds local = now - *above_->began;
    return next_above_ && next_above_->continues ? std::min(local, above_->span.length() - 1ns) : local;
}

TapestryPreview::Changes TapestryPreview::take_changes() {
    return std::exchange(changes_, {});
}

/// Requests a part of the film as a source of its own. It starts inside a shot if the shots are known. If
/// that shot is stored, it plays from the store and ends with the shot at the latest.
PlayingSpan TapestryPreview::request(const FilmSpan& wanted, double width) {
    Shot shot{.begin = std::clamp(wanted.begin, 0ns, std::max(0ns, film_.duration - min_span)), .stored = {}};
    const Shot* within = shot_at(film_.shots, shot.begin);
    if (within != nullptr)
        shot.begin = std::clamp(shot.begin, within->begin, std::max(within->begin, within->end - min_span));
    shot.end = std::min(shot.begin + wanted.length(), film_.duration);
    if (within != nullptr && within->stored) {
        shot.end = std::min(shot.end, within->end);
        shot.stored = within->stored;
        shot.stored->begin += shot.begin - within->begin;
    }
    const Vec2 whole = whole_picture(film_, {width, width * film_.picture.y / film_.picture.x});
    const PlayingSpan playing{.source = ++last_source_, .span = {shot.begin, shot.end}, .began = {}};
    changes_.requests.push_back({.source = playing.source,
                                 .path = film_.path,
                                 .kind = MediaKind::film,
                                 .shot = shot,
                                 .width = std::max(1, static_cast<int>(std::lround(whole.x))),
                                 .height = std::max(1, static_cast<int>(std::lround(whole.y)))});
    return playing;
}

void TapestryPreview::retire(std::optional<PlayingSpan>& playing) {
    if (playing) changes_.retired.push_back(playing->source);
    playing.reset();
}

}  // namespace vitrine::player
