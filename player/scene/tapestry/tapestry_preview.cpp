#include "player/scene/tapestry/tapestry_preview.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto span_above = 60s;    // longest part above the strip; then the next part follows
constexpr auto film_rest = 400ms;   // a shorter rest of the film is not played
constexpr auto preparing = 1500ms;  // the next span is requested so long before a span's end
constexpr auto sent_back = 100ms;   // another source is asked for rather than one sent back further
constexpr auto sent_on = 1s;        // another source is asked for rather than one sent on further
constexpr auto before_end = 2ms;    // a film stands so long before its end: pictures are drawn up to a
                                    // millisecond early, and then its part begins anew
constexpr nanoseconds at_next_frame{-1};

/// True if what plays can be drawn at another time of its own from now on.
bool can_follow(nanoseconds local, nanoseconds wanted) {
    return wanted >= local - sent_back && wanted <= local + sent_on;
}

/// True: the film is over with this span.
bool is_last(const PlayingSpan& playing, const PreviewedFilm& film) {
    return playing.span.end >= film.duration - film_rest;
}

}  // namespace

/// Where a finger has looked for this moment, its picture is there already and goes on from there.
void TapestryPreview::play(nanoseconds from, double width) {
    spans_.retire(next_above_);
    if (const std::optional<PlayingSpan> found = scrubbed_.take(from)) {
        spans_.retire(above_);
        above_ = found;
        above_->began = at_next_frame;
        return scrubbed_.stop();
    }
    next_above_ = spans_.request({from, from + span_above}, width);
}

void TapestryPreview::play_in_place(const FilmSpan& span, double width) {
    spans_.retire(in_place_);
    in_place_ = spans_.request(span, width);
}

void TapestryPreview::play_on(nanoseconds now, double width) {
    if (!has_begun(above_) || scrubbed_.moment()) return;
    const nanoseconds left = *above_->began + above_->span.length() - now;
    if (left <= preparing && !next_above_ && !is_last(*above_, spans_.film()) &&
        spans_.can_play(above_->span.end)) {
        next_above_ = spans_.request({above_->span.end, above_->span.end + span_above}, width);
        next_above_->continues = true;
    }
    if (left.count() > 0 || !next_above_ || !next_above_->continues || !next_above_->began) return;
    spans_.retire(above_);
    above_ = std::exchange(next_above_, std::nullopt);
    above_->continues = false;
}

void TapestryPreview::look_at(nanoseconds moment, double width) {
    spans_.retire(next_above_);
    scrubbed_.look_at(moment, width);
}

void TapestryPreview::stop_preview() {
    spans_.retire(above_);
    scrubbed_.stop();
    if (next_above_ && next_above_->continues) spans_.retire(next_above_);
}

void TapestryPreview::stop_in_place() {
    spans_.retire(in_place_);
}

void TapestryPreview::stop_outdated() {
    spans_.retire(next_above_);
    spans_.retire(in_place_);
    scrubbed_.stop();
}

void TapestryPreview::stop_all() {
    spans_.retire(above_);
    stop_outdated();
}

void TapestryPreview::source_ready(SourceId source) {
    scrubbed_.source_ready(source);
    if (next_above_ && next_above_->source == source) {
        next_above_->began = at_next_frame;
        if (!next_above_->continues) {
            spans_.retire(above_);
            above_ = std::exchange(next_above_, std::nullopt);
            scrubbed_.stop();
        }
    }
    if (in_place_ && in_place_->source == source) in_place_->began = at_next_frame;
}

void TapestryPreview::source_failed(SourceId source) {
    if (const std::optional<FilmSpan> failed = scrubbed_.source_failed(source)) spans_.note_failed(*failed);
    for (std::optional<PlayingSpan>* playing : {&above_, &next_above_, &in_place_})
        if (*playing && (*playing)->source == source) {
            spans_.note_failed((*playing)->span);
            spans_.retire(*playing);
        }
}

/// A part that begins in the middle of what plays elsewhere is asked for from its present moment on.
void TapestryPreview::follow(const TapestryMoment& seen, nanoseconds now, double width, double brick_width) {
    if (!seen.in_place || !spans_.can_play(seen.in_place->span.begin))
        stop_in_place();
    else if (!in_place_ || in_place_->span.begin != seen.in_place->span.begin)
        play_in_place(seen.in_place->span, brick_width);
    else if (has_begun(in_place_))
        in_place_->began = seen.in_place->began;
    if (seen.looked_for && spans_.can_play(*seen.looked_for)) return look_at(*seen.looked_for, width);
    if (seen.looked_for) return scrubbed_.look_at_kept(*seen.looked_for);
    if (!seen.above) return stop_preview();
    const FilmSpan& span = seen.above->span;
    const nanoseconds moment = span.begin + std::max(now - seen.above->began, nanoseconds(0));
    const nanoseconds bounded = std::min(moment, span.end - before_end);
    const bool looks = scrubbed_.moment().has_value();
    if (!looks && above_ && (above_->span.contains(moment) || above_->span.contains(bounded))) {
        if (!has_begun(above_)) return;
        const bool goes_on = next_above_ && next_above_->continues;
        const nanoseconds local =
            goes_on ? moment - above_->span.begin
                    : std::min(moment - above_->span.begin, above_->span.length() - before_end);
        if (can_follow(now - *above_->began, local)) {
            above_->began = now - local;
            return;
        }
    }
    const bool can_play = spans_.can_play(bounded);
    if (looks || !can_play) scrubbed_.look_at_kept(bounded);
    const bool comes = next_above_ && next_above_->span.contains(bounded);
    if (can_play && !comes) play(bounded, width);
}

void TapestryPreview::start_ready(nanoseconds now) {
    for (std::optional<PlayingSpan>* playing : {&above_, &in_place_})
        if (*playing && (*playing)->began && (*playing)->began->count() < 0) (*playing)->began = now;
}

nanoseconds TapestryPreview::time_above(nanoseconds now) const {
    const nanoseconds local = now - *above_->began;
    const bool stands = (next_above_ && next_above_->continues) || is_last(*above_, spans_.film());
    return stands ? std::min(local, above_->span.length() - before_end) : local;
}

std::optional<nanoseconds> TapestryPreview::awaited() const {
    if (!next_above_ || next_above_->continues) return std::nullopt;
    return next_above_->span.begin;
}

std::optional<nanoseconds> TapestryPreview::playhead(nanoseconds now) const {
    if (scrubbed_.moment()) return scrubbed_.moment();
    if (!has_begun(above_)) return std::nullopt;
    const nanoseconds length = above_->span.length();
    const nanoseconds local = time_above(now);
    return above_->span.begin + (length.count() > 0 ? local % length : local);
}

std::optional<nanoseconds> TapestryPreview::ended(nanoseconds now) const {
    if (!has_begun(above_) || !is_last(*above_, spans_.film()) || next_above_ || scrubbed_.moment())
        return std::nullopt;
    const nanoseconds end = *above_->began + above_->span.length();
    return now >= end ? std::optional(end) : std::nullopt;
}

}  // namespace vitrine::player
