#include "player/scene/tapestry/tapestry_show.hpp"

#include "player/scene/tapestry/kept_frames.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto own_interval = 12s;  // between two previews that the show starts by itself
constexpr auto last_picture = 3s;   // time for which the film's last picture stands
constexpr std::int64_t min_tiles = 16;

std::size_t max_tiles(const Tapestry& tapestry, std::int64_t bytes) {
    const std::int64_t tile = std::int64_t{4} * tapestry.tile_width * tapestry.height;
    return static_cast<std::size_t>(std::max(min_tiles, bytes / tile));
}

/// The tiles to be read. What a finger looks for comes before all others.
std::vector<TileId> missing_tiles(const TileCache& tiles, const TileCache& kept, bool is_looking) {
    std::vector<TileId> first = is_looking ? kept.missing() : tiles.missing();
    const std::vector<TileId> second = is_looking ? tiles.missing() : kept.missing();
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

}  // namespace

TapestryShow::TapestryShow(Tapestry tapestry, PreviewedFilm film, Vec2 canvas,
                           const TapestrySettings& settings)
    : tapestry_(std::move(tapestry)),
      sources_{settings.first_source},
      patience_(settings.patience),
      boxes_(tapestry_boxes(canvas, film.picture)),
      motion_({.centre = settings.first_seen}, settings.pace),
      tiles_(max_tiles(tapestry_, settings.max_tile_bytes)),
      kept_(max_kept_pictures),
      spans_(std::move(film), sources_.film()),
      preview_(spans_) {
    if (settings.plays_at_once) preview_.play(settings.first_seen, boxes_.preview.width());
}

void TapestryShow::set_canvas(Vec2 canvas) {
    if (canvas == boxes_.canvas) return;
    boxes_ = tapestry_boxes(canvas, film().picture);
    preview_.stop_outdated();
}

void TapestryShow::set_film(PreviewedFilm film) {
    spans_.set_film(std::move(film));
    boxes_ = tapestry_boxes(boxes_.canvas, this->film().picture);
}

void TapestryShow::handle_gesture(const Gesture& gesture) {
    touched_.reset();
    finger_.handle_gesture(gesture, touched_strip());
    is_over_ = is_over_ || finger_.has_closed();
}

void TapestryShow::tile_ready(const TileId& tile, TileZooms zooms) {
    TileCache& cache = is_of_level(tapestry_, tile) ? tiles_ : kept_;
    for (const TileId& gone : cache.add(tile, std::move(zooms)))
        retired_tiles_.push_back(sources_.tile(gone));
}

std::vector<SourceId> TapestryShow::close() {
    preview_.stop_all();
    std::vector<SourceId> retired = spans_.take_changes().retired;
    for (const SourceId tile : std::exchange(retired_tiles_, {}))
        retired.push_back(tile);
    for (TileCache* cache : {&tiles_, &kept_})
        for (const TileId& tile : cache->clear())
            retired.push_back(sources_.tile(tile));
    retired.push_back(sources_.mark());
    return retired;
}

/// Leaves when nobody has touched the tapestry for long, and a moment after the film's end. Where nobody
/// leaves, the film begins anew. While the strip moves by itself, plays what is in the middle of the view
/// from time to time, unless a visitor has chosen what plays.
void TapestryShow::leave_or_play(nanoseconds now) {
    if (!touched_) touched_ = now;
    if (patience_ && now - *touched_ >= *patience_) is_over_ = true;
    const std::optional<nanoseconds> end = preview_.ended(now);
    if (end && now - std::max(*end, *touched_) >= last_picture) {
        touched_ = now;
        finger_.forget_choice();
        is_over_ = is_over_ || patience_;
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

TapestryStep TapestryShow::step(nanoseconds now) {
    const TapestryPlace here = place();
    motion_.follow(preview_.playhead(now));
    motion_.advance(now, here);
    finger_.advance(now, touched_strip());
    tiles_.set_wanted(wanted_tiles(here, view(), motion_.direction(), tiles_.max_tiles()));
    kept_.set_wanted(wanted_pictures(here, view(), tapestry_, preview_.scrubbed().moment()));
    leave_or_play(now);
    preview_.play_on(now, boxes_.preview.width());
    preview_.start_ready(now);
    const DrawnTapestry drawn{.tapestry = tapestry_,
                              .tiles = tiles_,
                              .kept = kept_,
                              .film = film(),
                              .preview = preview_,
                              .touched = finger_.touched(),
                              .view = view(),
                              .boxes = boxes_,
                              .sources = sources_};
    FilmSpans::Changes changes = spans_.take_changes();
    TapestryStep step{.frame = tapestry_frame(drawn, now),
                      .missing = missing_tiles(tiles_, kept_, preview_.scrubbed().moment().has_value()),
                      .requests = std::move(changes.requests),
                      .retired = std::move(changes.retired)};
    for (const SourceId tile : std::exchange(retired_tiles_, {}))
        step.retired.push_back(tile);
    return step;
}

}  // namespace vitrine::player
