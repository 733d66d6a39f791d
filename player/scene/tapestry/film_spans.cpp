#include "player/scene/tapestry/film_spans.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto span_in_strip = 4s;      // longest part in place; then it repeats
constexpr auto min_loop = 1s;           // shortest part in place: a shorter loop flickers
constexpr auto min_rest = 400ms;        // shortest part before the film's end
constexpr std::size_t max_failed = 16;  // failed spans that are remembered
constexpr auto min_stored = 1s;         // a shorter part of a stored shot is not worth a source of its own

/// The shot that contains a time; nullptr: it lies between two shots, or the shots are not known.
const Shot* shot_with(const std::vector<Shot>& shots, nanoseconds time) {
    const auto found =
        std::ranges::upper_bound(shots, time, std::less<>(), [](const Shot& shot) { return shot.end; });
    return found == shots.end() || found->begin > time ? nullptr : &*found;
}

bool is_in_store(const Shot& shot) {
    return shot.stored && !shot.stored->is_dropped;
}

/// The part of a film from a time to another at most. It lies in a stored shot as a whole, or in none.
Shot part_of(const std::vector<Shot>& shots, FilmSpan wanted) {
    Shot part{.begin = wanted.begin, .end = wanted.end, .stored = {}};
    const Shot* within = shot_with(shots, part.begin);
    if (within != nullptr && is_in_store(*within) &&
        (within->end - part.begin >= min_stored || within->end >= part.end)) {
        part.end = std::min(part.end, within->end);
        part.stored = within->stored;
        part.stored->begin += part.begin - within->begin;
        return part;
    }
    const auto next = std::ranges::find_if(
        shots, [&](const Shot& shot) { return is_in_store(shot) && shot.begin >= part.begin + min_stored; });
    if (next != shots.end()) part.end = std::min(part.end, next->begin);
    return part;
}

}  // namespace

FilmSpans::FilmSpans(PreviewedFilm film, SourceId last_source)
    : film_(std::move(film)), last_source_(last_source) {}

nanoseconds FilmSpans::possible_begin(nanoseconds from) const {
    return std::clamp(from, nanoseconds(0), std::max(nanoseconds(0), film_.duration - min_rest));
}

void FilmSpans::note_failed(const FilmSpan& span) {
    failed_.push_back(span);
    if (failed_.size() > max_failed) failed_.pop_front();
}

bool FilmSpans::can_play(nanoseconds from) const {
    if (std::ranges::any_of(failed_, [&](const FilmSpan& span) { return span.contains(from); })) return false;
    return !has_store_alone_ || part_of(film_.shots, {from, film_.duration}).stored.has_value();
}

FilmSpan FilmSpans::span_in_place(nanoseconds from) const {
    const nanoseconds begin = possible_begin(from);
    nanoseconds end = begin + span_in_strip;
    if (const Shot* within = shot_with(film_.shots, begin); within != nullptr)
        end = std::clamp(within->end, nanoseconds(begin + min_loop), end);
    return {begin, std::min(end, film_.duration)};
}

PlayingSpan FilmSpans::request(const FilmSpan& wanted, double width) {
    const nanoseconds begin = possible_begin(wanted.begin);
    const Shot shot = part_of(film_.shots, {begin, std::min(begin + wanted.length(), film_.duration)});
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

void FilmSpans::retire(std::optional<PlayingSpan>& playing) {
    if (playing) changes_.retired.push_back(playing->source);
    playing.reset();
}

FilmSpans::Changes FilmSpans::take_changes() {
    return std::exchange(changes_, {});
}

}  // namespace vitrine::player
