#include "player/scene/tapestry/tapestry_show.hpp"

#include "player/scene/tapestry/unwoven_tapestry.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto own_interval = 12s;  // between two previews that the show starts by itself
constexpr auto last_picture = 3s;   // time for which the film's last picture stands

/// A strip that is not woven yet has no pictures to strike.
KeyframeEdit* edit_on(std::optional<KeyframeEdit>& edit, const Tapestry& tapestry) {
    return edit && !is_unwoven(tapestry) ? &*edit : nullptr;
}

/// The choice whose marks are drawn; nullptr: keyframes are not edited.
/// @param seen  see TapestryShow::step
const KeyframeChoice* edited_choice(const std::optional<KeyframeEdit>& edit, const TapestryMoment* seen) {
    if (seen != nullptr) return seen->edited ? &*seen->edited : nullptr;
    return edit ? &edit->choice() : nullptr;
}

std::optional<SeenSpan> seen_span(const std::optional<PlayingSpan>& playing) {
    if (!has_begun(playing)) return std::nullopt;
    return SeenSpan{playing->span, *playing->began};
}

/// The moment of a frame that is drawn, but for the time at which the show was opened.
/// @param width  canvas px of the whole film
TapestryMoment seen_moment(const DrawnTapestry& drawn, double width) {
    return {.path = drawn.film.path,
            .folder = drawn.tapestry.folder,
            .levels = static_cast<int>(drawn.tapestry.levels.size()),
            .room = drawn.boxes.room,
            .view = drawn.view,
            .width = width,
            .above = seen_span(drawn.preview.above()),
            .in_place = seen_span(drawn.preview.in_place()),
            .touched = drawn.touched,
            .looked_for = drawn.preview.scrubbed().moment(),
            .edited = drawn.edited != nullptr ? std::optional(*drawn.edited) : std::nullopt};
}

}  // namespace

TapestryShow::TapestryShow(Tapestry tapestry, PreviewedFilm film, const TapestryRoom& room,
                           const TapestrySettings& settings)
    : strips_(std::move(tapestry), settings.first_source, settings.max_tile_bytes),
      patience_(settings.patience),
      boxes_(tapestry_boxes(room, film.picture)),
      motion_({.centre = settings.first_seen}, settings.pace),
      spans_(std::move(film), sources().film()),
      preview_(spans_) {
    if (settings.edited) edit_.emplace(*settings.edited);
    if (settings.plays_at_once) preview_.play(settings.first_seen, boxes_.preview.width());
}

void TapestryShow::set_room(const TapestryRoom& room) {
    if (room == boxes_.room) return;
    boxes_ = tapestry_boxes(room, film().picture);
    const std::optional<std::chrono::nanoseconds> awaited = preview_.awaited();
    preview_.stop_outdated();
    if (awaited) preview_.play(*awaited, boxes_.preview.width());
}

void TapestryShow::set_film(PreviewedFilm film) {
    spans_.set_film(std::move(film));
    boxes_ = tapestry_boxes(boxes_.room, this->film().picture);
}

void TapestryShow::handle_gesture(const Gesture& gesture) {
    touched_.reset();
    KeyframeEdit* const edit = edit_on(edit_, tapestry());
    finger_.handle_gesture(gesture, {place(), boxes_, spans_, motion_, preview_, edit});
    is_over_ = is_over_ || finger_.has_closed();
}

std::vector<SourceId> TapestryShow::close() {
    preview_.stop_all();
    strips_.clear();
    std::vector<SourceId> retired = spans_.take_changes().retired;
    for (const SourceId tile : strips_.take_retired())
        retired.push_back(tile);
    retired.push_back(sources().mark());
    return retired;
}

/// Moves as visitors want. Leaves when nobody has touched the tapestry for long, and a moment after the
/// film's end. Where nobody leaves, or keyframes are edited, the film begins anew. While the strip moves by
/// itself, plays what is in the middle of the view from time to time, unless a visitor has chosen what plays.
void TapestryShow::go_on(nanoseconds now) {
    motion_.follow(preview_.playhead(now));
    motion_.advance(now, place());
    finger_.advance(now, {place(), boxes_, spans_, motion_, preview_, edit_on(edit_, tapestry())});
    if (!touched_) touched_ = now;
    if (patience_ && now - *touched_ >= *patience_) is_over_ = true;
    const std::optional<nanoseconds> end = preview_.ended(now);
    if (end && now - std::max(*end, *touched_) >= last_picture) {
        touched_ = now;
        finger_.forget_choice();
        is_over_ = is_over_ || (patience_ && !edit_);
        if (!is_over_) preview_.play(nanoseconds(0), boxes_.preview.width());
    }
    const bool is_chosen = preview_.above() && (finger_.has_chosen() || patience_);
    if (!motion_.is_by_itself() || is_chosen) {
        played_ = now - own_interval;
    } else if (now - played_ >= own_interval) {
        played_ = now;
        preview_.stop_in_place();
        preview_.play(view().centre, boxes_.preview.width());
    }
}

/// Shows the same as another box.
void TapestryShow::follow(const TapestryMoment& seen, nanoseconds now) {
    spans_.use_store_alone();
    motion_.show(view_of_width(place(), seen.view, seen.width));
    const Box brick = place().brick(view(), seen.touched, film().picture);
    preview_.follow(seen, now, boxes_.preview.width(), brick.width());
}

TapestryStep TapestryShow::step(nanoseconds now, const TapestryMoment* seen) {
    strips_.advance(now, boxes_, motion_);
    if (seen != nullptr)
        follow(*seen, now);
    else
        go_on(now);
    TapestryStrip& strip = strips_.shown();
    const std::optional<ComingStrip>& coming = strips_.coming();
    strip.want_all(place(), view(), motion_.direction(), preview_.scrubbed().moment());
    preview_.play_on(now, boxes_.preview.width());
    preview_.start_ready(now);
    const DrawnTapestry drawn{.tapestry = strip.tapestry(),
                              .tiles = strip.tiles(),
                              .kept = strip.kept(),
                              .film = film(),
                              .preview = preview_,
                              .touched = seen != nullptr ? seen->touched : finger_.touched(),
                              .view = view(),
                              .boxes = boxes_,
                              .sources = strip.sources(),
                              .coming = coming ? coming->drawn(now) : std::nullopt,
                              .edited = edited_choice(edit_, seen)};
    FilmSpans::Changes changes = spans_.take_changes();
    TapestryStep step{.frame = tapestry_frame(drawn, now),
                      .missing = strip.missing(preview_.scrubbed().moment().has_value()),
                      .coming = coming ? coming->strip().missing(false) : std::vector<TileId>{},
                      .requests = std::move(changes.requests),
                      .retired = std::move(changes.retired),
                      .seen = seen_moment(drawn, place().width(view().level))};
    for (const SourceId tile : strips_.take_retired())
        step.retired.push_back(tile);
    return step;
}

}  // namespace vitrine::player
