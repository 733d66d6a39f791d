#include "player/scene/tapestry_strip.hpp"

#include "player/scene/compose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine {

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
constexpr auto appearing = 300ms;      // that what begins to play fades in
constexpr double blend_begin =
    0.2;  // of the way from a level to the next: there the finer one begins to be seen
constexpr double blend_end = 0.8;   // there it is all that is seen
constexpr double soft_edge = 0.14;  // of the height of what plays in place
constexpr int edge_points = 6;      // a side, of the soft edge
constexpr int level_bits = 26;      // a tile's number within its level, in its source's number
constexpr SourceId film_bit = SourceId{1} << 40;

std::vector<std::array<Vec2, 3>> triangles_of(const Box& box) {
    const Vec2 right_top{box.max.x, box.min.y};
    const Vec2 left_bottom{box.min.x, box.max.y};
    return {{box.min, right_top, box.max}, {box.min, box.max, left_bottom}};
}

/// A cell that is a box, with clean edges.
std::shared_ptr<const Cell> box_cell(const Box& box) {
    return std::make_shared<const Cell>(Cell{.parts = {to_polygon(box)},
                                             .filler = {},
                                             .triangles = triangles_of(box),
                                             .filler_triangles = {},
                                             .rims = {Rim{}}});
}

/// A box that fades out over what lies around it.
std::shared_ptr<const Cell> soft_cell(const Box& box, double edge) {
    const Box inner{box.min + Vec2{edge, edge}, box.max - Vec2{edge, edge}};
    const Polygon corners = to_polygon(inner);
    Rim rim;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int k = 0; k < edge_points; ++k)
            rim.outline.push_back(corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) *
                                                   (static_cast<double>(k) / edge_points));
    rim.widths.assign(rim.outline.size(), edge);
    return std::make_shared<const Cell>(Cell{.parts = {corners},
                                             .filler = {},
                                             .triangles = triangles_of(inner),
                                             .filler_triangles = {},
                                             .rims = {rim},
                                             .rim_coverage = 1});
}

std::size_t most_tiles(const Tapestry& tapestry, std::int64_t bytes) {
    const std::int64_t tile = std::int64_t{4} * tapestry.tile_width * tapestry.height;
    return static_cast<std::size_t>(std::max<std::int64_t>(16, bytes / tile));
}

}  // namespace

TapestryStrip::TapestryStrip(Tapestry tapestry, Vec2 picture, Vec2 canvas, const StripSettings& settings)
    : tapestry_(std::move(tapestry)),
      picture_(picture),
      settings_(settings),
      motion_({}, settings.pace),
      cache_(most_tiles(tapestry_, settings.most_tile_bytes)),
      last_source_(settings.first_source | film_bit) {
    lay_out(canvas);
}

void TapestryStrip::lay_out(Vec2 canvas) {
    canvas_ = canvas;
    box_ = {{0, std::round(strip_top * canvas.y)},
            {canvas.x, std::round((strip_top + strip_height) * canvas.y)}};
    const double height = std::min(preview_room * canvas.y, 0.9 * canvas.x * picture_.y / picture_.x);
    const double half = height * picture_.x / picture_.y / 2;
    const double top = preview_top * canvas.y + (preview_room * canvas.y - height) / 2;
    preview_ = {{std::round(canvas.x / 2 - half), std::round(top)},
                {std::round(canvas.x / 2 + half), std::round(top + height)}};
}

void TapestryStrip::set_canvas(Vec2 canvas) {
    if (canvas == canvas_) return;
    lay_out(canvas);
    retire(incoming_);
    retire(in_place_);
}

SourceId TapestryStrip::source_of(const TileId& tile) const {
    return settings_.first_source + (SourceId{tile.level + 1} << level_bits) +
           static_cast<SourceId>(tile.tile);
}

void TapestryStrip::take(const Gesture& gesture) {
    is_touched_ = true;
    const bool is_on_strip = gesture.from.y >= box_.min.y;
    switch (gesture.kind) {
    case Gesture::Kind::tap:
        motion_.touch();
        if (!is_on_strip) return retire(shown_);
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
        break;
    default:
        break;
    }
    motion_.take(gesture, place());
}

void TapestryStrip::tile_ready(const TileId& tile) {
    for (const TileId& gone : cache_.add(tile))
        retired_.push_back(source_of(gone));
}

std::vector<SourceId> TapestryStrip::close() {
    for (std::optional<Playing>* playing : {&shown_, &incoming_, &in_place_})
        retire(*playing);
    for (const TileId& tile : cache_.clear())
        retired_.push_back(source_of(tile));
    retired_.push_back(mark());
    return std::exchange(retired_, {});
}

void TapestryStrip::forget_tiles() {
    cache_.clear();
}

void TapestryStrip::source_ready(SourceId source) {
    if (incoming_ && incoming_->source == source) {
        retire(shown_);
        shown_ = std::exchange(incoming_, std::nullopt);
        shown_->began = nanoseconds(-1);  // with the next picture
    }
    if (in_place_ && in_place_->source == source) in_place_->began = nanoseconds(-1);
}

void TapestryStrip::source_failed(SourceId source) {
    for (std::optional<Playing>* playing : {&shown_, &incoming_, &in_place_})
        if (*playing && (*playing)->source == source) retire(*playing);
}

void TapestryStrip::retire(std::optional<Playing>& playing) {
    if (playing) retired_.push_back(playing->source);
    playing.reset();
}

TapestryStrip::Playing TapestryStrip::stretch(nanoseconds from, nanoseconds length, double width) {
    const nanoseconds begin =
        std::clamp(from, nanoseconds(0), std::max(nanoseconds(0), tapestry_.duration - 1s));
    const Playing playing{
        .source = ++last_source_, .begin = begin, .end = std::min(begin + length, tapestry_.duration)};
    requests_.push_back(
        {.source = playing.source,
         .path = tapestry_.path,
         .kind = MediaKind::video,
         .shot = {.begin = playing.begin, .end = playing.end},
         .width = std::max(1, static_cast<int>(std::lround(width))),
         .height = std::max(1, static_cast<int>(std::lround(width * picture_.y / picture_.x)))});
    return playing;
}

void TapestryStrip::play(nanoseconds from) {
    retire(incoming_);
    incoming_ = stretch(from, preview_length, preview_.width());
}

void TapestryStrip::play_in_place(nanoseconds from) {
    retire(in_place_);
    in_place_ = stretch(from, in_place_length, brick(from).width());
}

/// Where a keyframe's picture is about, of the moment that plays: in the upper row or in the lower one.
Box TapestryStrip::brick(nanoseconds time) const {
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
void TapestryStrip::play_by_itself(nanoseconds now) {
    if (!motion_.is_by_itself()) {
        played_ = now - own_interval;
        return;
    }
    if (now - played_ < own_interval) return;
    played_ = now;
    retire(in_place_);
    play(view().centre);
}

StripStep TapestryStrip::step(nanoseconds now) {
    if (std::exchange(is_touched_, false)) touched_ = now;
    if (settings_.patience && now - touched_ >= *settings_.patience) is_over_ = true;
    const TapestryPlace here = place();
    motion_.advance(now, here);
    cache_.wish(wanted_tiles(here, view(), motion_.direction(), cache_.most()));
    play_by_itself(now);
    StripStep step{.frame = picture(now), .missing = cache_.missing()};
    step.requests = std::exchange(requests_, {});
    step.retired = std::exchange(retired_, {});
    return step;
}

Frame TapestryStrip::picture(nanoseconds now) {
    Frame frame{.canvas = canvas_, .idle = 1, .time = now};
    const auto coarse = static_cast<std::size_t>(view().level);
    const double share = view().level - static_cast<double>(coarse);
    const double alpha = eased((share - blend_begin) / (blend_end - blend_begin));
    if (!is_whole(share > 0 && alpha >= 1 ? coarse + 1 : coarse)) draw_level(frame, 0, 1);
    if (alpha < 1) draw_level(frame, coarse, 1);
    if (alpha > 0) draw_level(frame, coarse + 1, alpha);
    draw_in_place(frame);
    draw_preview(frame);
    if (shown_ && shown_->began) draw_playhead(frame, *shown_);
    return frame;
}

/// Whether all that is seen of a level can be drawn.
bool TapestryStrip::is_whole(std::size_t level) const {
    return std::ranges::all_of(place().tiles(view(), level, box_.min.x, box_.max.x),
                               [&](const auto& tile) { return cache_.has(tile.first); });
}

void TapestryStrip::draw_level(Frame& frame, std::size_t level, double alpha) const {
    for (const TilePiece& piece : place().pieces(view(), level, box_.min.x, box_.max.x)) {
        if (!cache_.has(piece.tile)) continue;
        const double width = (piece.right - piece.left) / (piece.last - piece.first);
        frame.items.push_back(
            {.source = source_of(piece.tile),
             .cell = box_cell({{piece.left, box_.min.y}, {piece.right, box_.max.y}}),
             .placement = {.scale = 1, .offset = {piece.left - piece.first * width, box_.min.y}},
             .picture = {width, box_.height()},
             .alpha = alpha});
    }
}

void TapestryStrip::draw_in_place(Frame& frame) {
    if (!in_place_ || !in_place_->began) return;
    if (in_place_->began->count() < 0) in_place_->began = frame.time;
    const nanoseconds local = frame.time - *in_place_->began;
    const Box at = brick(in_place_->begin);
    const double alpha =
        eased(std::chrono::duration<double>(local) / std::chrono::duration<double>(appearing));
    frame.items.push_back({.source = in_place_->source,
                           .cell = soft_cell(at, soft_edge * at.height()),
                           .placement = {.scale = 1, .offset = at.min},
                           .picture = {at.width(), at.height()},
                           .local = local,
                           .alpha = std::min(alpha, 0.999)});
}

void TapestryStrip::draw_preview(Frame& frame) {
    if (!shown_ || !shown_->began) return;
    if (shown_->began->count() < 0) shown_->began = frame.time;
    frame.items.push_back({.source = shown_->source,
                           .cell = box_cell(preview_),
                           .placement = {.scale = 1, .offset = preview_.min},
                           .picture = {preview_.width(), preview_.height()},
                           .local = frame.time - *shown_->began,
                           .alpha = 1});
}

/// A line through the strip at what plays above it.
void TapestryStrip::draw_playhead(Frame& frame, const Playing& playing) const {
    const nanoseconds length = playing.end - playing.begin;
    const nanoseconds local = frame.time - *playing.began;
    const double x =
        std::round(place().canvas_x(view(), playing.begin + (length.count() > 0 ? local % length : local)));
    const double half = std::max(1.0, std::round(canvas_.y / 720));
    if (x < box_.min.x || x > box_.max.x) return;
    frame.items.push_back({.source = mark(),
                           .cell = box_cell({{x - half, box_.min.y}, {x + half, box_.max.y}}),
                           .placement = {.scale = 1, .offset = {x - half, box_.min.y}},
                           .picture = {2 * half, box_.height()},
                           .alpha = 0.85});
}

}  // namespace vitrine
