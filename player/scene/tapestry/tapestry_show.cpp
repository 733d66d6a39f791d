#include "player/scene/tapestry/tapestry_show.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto own_interval = 12s;      // between two previews that the show starts by itself
constexpr double closing_pinch = 0.75;  // factor of a pinch at the coarsest level that closes the tapestry
constexpr std::int64_t min_tiles = 16;

std::size_t max_tiles(const Tapestry& tapestry, std::int64_t bytes) {
    const std::int64_t tile = std::int64_t{4} * tapestry.tile_width * tapestry.height;
    return static_cast<std::size_t>(std::max(min_tiles, bytes / tile));
}

bool contains(const Box& box, Vec2 point) {
    return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

}  // namespace

TapestryShow::TapestryShow(Tapestry tapestry, Vec2 picture, Vec2 canvas, const TapestrySettings& settings)
    : tapestry_(std::move(tapestry)),
      sources_{settings.first_source},
      patience_(settings.patience),
      boxes_(tapestry_boxes(canvas, picture)),
      motion_({.centre = settings.first_seen}, settings.pace),
      tiles_(max_tiles(tapestry_, settings.max_tile_bytes)),
      preview_({.path = tapestry_.path,
                .duration = tapestry_.duration,
                .picture = picture,
                .active = settings.active,
                .shots = settings.shots},
               sources_.film()) {
    if (settings.plays_at_once) preview_.play(settings.first_seen, boxes_.preview.width());
}

void TapestryShow::set_canvas(Vec2 canvas) {
    if (canvas == boxes_.canvas) return;
    boxes_ = tapestry_boxes(canvas, preview_.film().picture);
    preview_.stop_outdated();
}

void TapestryShow::handle_gesture(const Gesture& gesture) {
    touched_.reset();
    switch (gesture.kind) {
    case Gesture::Kind::tap:
        motion_.touch();
        return handle_tap(gesture);
    case Gesture::Kind::hold:
        motion_.touch();
        if (gesture.from.y >= boxes_.strip.min.y) play_in_place(gesture.at.x);
        return;
    case Gesture::Kind::key:
        if (gesture.key == Key::back) is_over_ = true;
        if (gesture.key == Key::select) preview_.play(view().centre, boxes_.preview.width());
        break;
    case Gesture::Kind::pinch:
        preview_.stop_in_place();
        pinched_ = view().level > 0 ? 1 : pinched_ * gesture.factor;
        if (pinched_ < closing_pinch) is_over_ = true;
        break;
    case Gesture::Kind::pinch_end:
        pinched_ = 1;
        break;
    default:
        break;
    }
    motion_.handle_gesture(gesture, place());
}

/// Handles a tap: on the strip it plays the film from there, on the preview it closes the preview, elsewhere
/// it closes the tapestry.
void TapestryShow::handle_tap(const Gesture& tap) {
    if (tap.from.y >= boxes_.strip.min.y) {
        preview_.play(place().time_at(view(), tap.at.x), boxes_.preview.width());
        return play_in_place(tap.at.x);
    }
    if (!preview_.above() || !contains(boxes_.preview, tap.at)) is_over_ = true;
    preview_.stop_preview();
}

void TapestryShow::play_in_place(double canvas_x) {
    const FilmSpan span = preview_.span_in_place(place().time_at(view(), canvas_x));
    const Box brick = place().brick(view(), span.begin, preview_.film().picture);
    preview_.play_in_place(span, brick.width());
}

void TapestryShow::tile_ready(const TileId& tile, TileZooms zooms) {
    for (const TileId& gone : tiles_.add(tile, std::move(zooms)))
        retired_tiles_.push_back(sources_.tile(gone));
}

std::vector<SourceId> TapestryShow::close() {
    preview_.stop_all();
    std::vector<SourceId> retired = preview_.take_changes().retired;
    for (const SourceId tile : std::exchange(retired_tiles_, {}))
        retired.push_back(tile);
    for (const TileId& tile : tiles_.clear())
        retired.push_back(sources_.tile(tile));
    retired.push_back(sources_.mark());
    return retired;
}

/// While the strip moves by itself, starts the preview at the middle of the view from time to time.
void TapestryShow::play_by_itself(nanoseconds now) {
    if (!motion_.is_by_itself()) {
        played_ = now - own_interval;
        return;
    }
    if (now - played_ < own_interval) return;
    played_ = now;
    preview_.stop_in_place();
    preview_.play(view().centre, boxes_.preview.width());
}

TapestryStep TapestryShow::step(nanoseconds now) {
    if (!touched_) touched_ = now;
    if (patience_ && now - *touched_ >= *patience_) is_over_ = true;
    const TapestryPlace here = place();
    motion_.advance(now, here);
    tiles_.set_wanted(wanted_tiles(here, view(), motion_.direction(), tiles_.max_tiles()));
    play_by_itself(now);
    preview_.play_on(now, boxes_.preview.width());
    preview_.start_ready(now);
    const DrawnTapestry drawn{.tapestry = tapestry_,
                              .tiles = tiles_,
                              .preview = preview_,
                              .view = view(),
                              .boxes = boxes_,
                              .sources = sources_};
    TapestryPreview::Changes changes = preview_.take_changes();
    TapestryStep step{.frame = tapestry_frame(drawn, now),
                      .missing = tiles_.missing(),
                      .requests = std::move(changes.requests),
                      .retired = std::move(changes.retired)};
    for (const SourceId tile : std::exchange(retired_tiles_, {}))
        step.retired.push_back(tile);
    return step;
}

}  // namespace vitrine::player
