#include "player/scene/tapestry/tapestry_show.hpp"

#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr double strip_top = 0.62;     // of the canvas' height
constexpr double strip_height = 0.31;  // likewise
constexpr double preview_top = 0.05;   // likewise
constexpr double preview_room = 0.52;  // likewise
constexpr auto preview_length = 60s;   // that plays, then it begins again
constexpr auto in_place_length = 4s;   // likewise, within the strip
constexpr auto own_interval = 12s;     // between two previews that it begins by itself
constexpr double shut = 0.75;          // factor of a pinch at the coarsest level that leaves the strip
constexpr auto lead = 1500ms;          // that what comes next is got ready before it is due
constexpr int level_bits = 26;         // a tile's number within its level, in its source's number
constexpr SourceId film_bit = SourceId{1} << 40;

std::size_t most_tiles(const Tapestry& tapestry, std::int64_t bytes) {
    const std::int64_t tile = std::int64_t{4} * tapestry.tile_width * tapestry.height;
    return static_cast<std::size_t>(std::max<std::int64_t>(16, bytes / tile));
}

}  // namespace

TapestryShow::TapestryShow(Tapestry tapestry, Vec2 picture, Vec2 canvas, const TapestrySettings& settings)
    : tapestry_(std::move(tapestry)),
      picture_(picture),
      settings_(settings),
      motion_({.centre = settings.first_seen}, settings.pace),
      cache_(most_tiles(tapestry_, settings.most_tile_bytes)),
      last_source_(settings.first_source | film_bit) {
    lay_out(canvas);
    if (settings_.plays_at_once) play(settings_.first_seen);
}

void TapestryShow::lay_out(Vec2 canvas) {
    canvas_ = canvas;
    box_ = {{0, std::round(strip_top * canvas.y)},
            {canvas.x, std::round((strip_top + strip_height) * canvas.y)}};
    const double height = std::min(preview_room * canvas.y, 0.9 * canvas.x * picture_.y / picture_.x);
    const double half = height * picture_.x / picture_.y / 2;
    const double top = preview_top * canvas.y + (preview_room * canvas.y - height) / 2;
    preview_ = {{std::round(canvas.x / 2 - half), std::round(top)},
                {std::round(canvas.x / 2 + half), std::round(top + height)}};
}

void TapestryShow::set_canvas(Vec2 canvas) {
    if (canvas == canvas_) return;
    lay_out(canvas);
    retire(incoming_);
    retire(in_place_);
}

SourceId TapestryShow::source_of(const TileId& tile) const {
    return settings_.first_source + (SourceId{tile.level + 1} << level_bits) +
           static_cast<SourceId>(tile.tile);
}

void TapestryShow::handle_gesture(const Gesture& gesture) {
    is_touched_ = true;
    const bool is_on_strip = gesture.from.y >= box_.min.y;
    switch (gesture.kind) {
    case Gesture::Kind::tap:
        motion_.touch();
        if (!is_on_strip) return close_or_end(gesture.at);
        play(place().time_at(view(), gesture.at.x));
        return play_in_place(place().time_at(view(), gesture.at.x));
    case Gesture::Kind::hold:
        motion_.touch();
        if (is_on_strip) play_in_place(place().time_at(view(), gesture.at.x));
        return;
    case Gesture::Kind::key:
        if (gesture.key == Key::back) is_over_ = true;
        if (gesture.key == Key::select) play(view().centre);
        break;
    case Gesture::Kind::pinch:
        retire(in_place_);
        pinch_shut(gesture);
        break;
    case Gesture::Kind::pinch_end:
        pinched_ = 1;
        break;
    default:
        break;
    }
    motion_.handle_gesture(gesture, place());
}

/// A tap on the preview puts it away, one beside it leaves the strip.
void TapestryShow::close_or_end(Vec2 at) {
    const bool is_on_preview = shown_ && at.x >= preview_.min.x && at.x <= preview_.max.x &&
                               at.y >= preview_.min.y && at.y <= preview_.max.y;
    if (!is_on_preview) is_over_ = true;
    retire(shown_);
    if (incoming_ && incoming_->follows) retire(incoming_);
}

/// Fingers that come together where it cannot get any smaller.
void TapestryShow::pinch_shut(const Gesture& gesture) {
    pinched_ = view().level > 0 ? 1 : pinched_ * gesture.factor;
    if (pinched_ < shut) is_over_ = true;
}

void TapestryShow::tile_ready(const TileId& tile, TileZooms zooms) {
    zooms_[tile] = std::move(zooms);
    for (const TileId& gone : cache_.add(tile)) {
        retired_.push_back(source_of(gone));
        zooms_.erase(gone);
    }
}

std::vector<SourceId> TapestryShow::close() {
    for (std::optional<Playing>* playing : {&shown_, &incoming_, &in_place_})
        retire(*playing);
    for (const TileId& tile : cache_.clear())
        retired_.push_back(source_of(tile));
    zooms_.clear();
    retired_.push_back(mark());
    return std::exchange(retired_, {});
}

void TapestryShow::forget_tiles() {
    cache_.clear();
    zooms_.clear();
}

void TapestryShow::source_ready(SourceId source) {
    if (incoming_ && incoming_->source == source && incoming_->follows) {
        incoming_->began = nanoseconds(-1);
    } else if (incoming_ && incoming_->source == source) {
        retire(shown_);
        shown_ = std::exchange(incoming_, std::nullopt);
        shown_->began = nanoseconds(-1);  // with the next picture
    }
    if (in_place_ && in_place_->source == source) in_place_->began = nanoseconds(-1);
}

void TapestryShow::source_failed(SourceId source) {
    for (std::optional<Playing>* playing : {&shown_, &incoming_, &in_place_})
        if (*playing && (*playing)->source == source) retire(*playing);
}

void TapestryShow::retire(std::optional<Playing>& playing) {
    if (playing) retired_.push_back(playing->source);
    playing.reset();
}

TapestryShow::Playing TapestryShow::stretch(nanoseconds from, nanoseconds length, double width) {
    Shot shot{.begin = std::clamp(from, nanoseconds(0), std::max(nanoseconds(0), tapestry_.duration - 1s)),
              .stored = {}};
    const Shot* within = shot_at(shot.begin);
    if (within != nullptr)
        shot.begin = std::clamp(shot.begin, within->begin, std::max(within->begin, within->end - 1s));
    shot.end = std::min(shot.begin + length, tapestry_.duration);
    if (within != nullptr && within->stored) {
        shot.end = std::min(shot.end, within->end);
        shot.stored = within->stored;
        shot.stored->begin += shot.begin - within->begin;
    }
    const Playing playing{.source = ++last_source_, .begin = shot.begin, .end = shot.end, .began = {}};
    requests_.push_back(
        {.source = playing.source,
         .path = tapestry_.path,
         .kind = MediaKind::film,
         .shot = shot,
         .width = std::max(1, static_cast<int>(std::lround(width))),
         .height = std::max(1, static_cast<int>(std::lround(width * picture_.y / picture_.x)))});
    return playing;
}

/// The shot that a moment lies in, or the next one: what lies between two of them belongs to neither. Behind
/// the last it is the last; none where they are not known.
const Shot* TapestryShow::shot_at(nanoseconds time) const {
    const auto found = std::ranges::upper_bound(settings_.shots, time, std::less<>(),
                                                [](const Shot& shot) { return shot.end; });
    if (settings_.shots.empty()) return nullptr;
    return found == settings_.shots.end() ? &settings_.shots.back() : &*found;
}

/// The next stretch of what plays above: got ready in time, shown once the one before has ended.
void TapestryShow::play_on(nanoseconds now) {
    if (!shown_ || !shown_->began || shown_->began->count() < 0) return;
    const nanoseconds left = *shown_->began + shown_->length() - now;
    const nanoseconds end = settings_.shots.empty() ? tapestry_.duration - 1s : settings_.shots.back().end;
    if (left <= lead && !incoming_ && shown_->end < end) {
        incoming_ = stretch(shown_->end, preview_length, preview_.width());
        incoming_->follows = true;
    }
    if (left.count() > 0 || !incoming_ || !incoming_->follows || !incoming_->began) return;
    retire(shown_);
    shown_ = std::exchange(incoming_, std::nullopt);
    shown_->follows = false;
}

void TapestryShow::play(nanoseconds from) {
    retire(incoming_);
    incoming_ = stretch(from, preview_length, preview_.width());
}

/// Within one shot: what follows it belongs elsewhere on the strip.
void TapestryShow::play_in_place(nanoseconds from) {
    retire(in_place_);
    nanoseconds length = in_place_length;
    if (const Shot* within = shot_at(from); within != nullptr) {
        length = std::min(length, within->duration());
        from = std::clamp(from, within->begin, within->end - length);
    }
    in_place_ = stretch(from, length, brick(from).width());
}

/// Where a keyframe's picture is about, of the moment that plays: in the upper row or in the lower one.
Box TapestryShow::brick(nanoseconds time) const {
    const auto level = static_cast<std::size_t>(std::lround(view().level));
    const auto& keyframes = tapestry_.levels[level].keyframes;
    const double x = place().canvas_x(view(), time);
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < keyframes.size(); ++k)
        if (std::abs(place().canvas_x(view(), keyframes[k]) - x) <
            std::abs(place().canvas_x(view(), keyframes[nearest]) - x))
            nearest = k;
    const double scale = box_.height() / tapestry_.height;
    const double width = std::min(tapestry_.brick_width * scale, box_.height() * picture_.x / picture_.y);
    const double height = width * picture_.y / picture_.x;
    const double top = nearest % 2 == 0 ? box_.min.y : box_.max.y - height;
    const double middle = place().canvas_x(view(), keyframes[nearest]);
    return {{middle - width / 2, top}, {middle + width / 2, top + height}};
}

/// Where it moves by itself the film plays what is in the middle, anew every now and then.
void TapestryShow::play_by_itself(nanoseconds now) {
    if (!motion_.is_by_itself()) {
        played_ = now - own_interval;
        return;
    }
    if (now - played_ < own_interval) return;
    played_ = now;
    retire(in_place_);
    play(view().centre);
}

TapestryStep TapestryShow::step(nanoseconds now) {
    if (std::exchange(is_touched_, false)) touched_ = now;
    if (settings_.patience && now - touched_ >= *settings_.patience) is_over_ = true;
    const TapestryPlace here = place();
    motion_.advance(now, here);
    cache_.wish(wanted_tiles(here, view(), motion_.direction(), cache_.most()));
    play_by_itself(now);
    play_on(now);
    TapestryStep step{.frame = picture(now), .missing = cache_.missing()};
    step.requests = std::exchange(requests_, {});
    step.retired = std::exchange(retired_, {});
    return step;
}

}  // namespace vitrine::player
