#include "player/scene/tapestry/tapestry_picture.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/tapestry/kept_frames.hpp"
#include "player/scene/tapestry/unwoven_tapestry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr double strip_top = 0.62;     // share of the screen's height
constexpr double strip_height = 0.31;  // share of the screen's height
constexpr double preview_top = 0.05;   // share of the screen's height
constexpr double preview_room = 0.52;  // share of the screen's height, filled as the shape allows
constexpr double preview_width = 0.9;  // limit, as a share of the screen's width
constexpr int level_bits = 26;         // bits in a source's number for the number of a tile within its level
constexpr int generation_bit = 33;
constexpr SourceId film_bit = SourceId{1} << 40;
constexpr auto appearing = 300ms;        // fade-in of a film that starts to play in place
constexpr double blend_begin = 0.2;      // position between two levels from which the finer one is visible
constexpr double blend_end = 0.8;        // position from which only the finer one is visible
constexpr double soft_edge = 0.14;       // width, as a share of the height of the picture that plays in place
constexpr int edge_points = 6;           // points of each side of the soft edge
constexpr double nearly_opaque = 0.999;  // a soft edge needs an item that is not opaque
constexpr double playhead_alpha = 0.85;
constexpr double unwoven_alpha = 0.12;  // of the place of a strip that is not woven yet
constexpr double digit_height = 0.034;  // share of the screen's height
constexpr double digit_gap = 0.006;     // between digits and strip, share of the screen's height
constexpr auto alike = 40ms;            // a sharp picture so near to a moment shows it
constexpr double struck_alpha = 0.6;    // of the veil over a struck picture
constexpr double mark_gap = 0.012;      // between the strip and the marks below, share of the screen's height
constexpr double mark_length = 0.03;    // of a mark, share of the screen's height
constexpr double mark_width = 0.007;    // of a mark, share of the screen's height
constexpr double playhead_lines = 720;  // px of the screen's height for which half the playhead is 1 px wide

std::vector<std::array<Vec2, 3>> triangles_of(const Box& box) {
    const Vec2 right_top{box.max.x, box.min.y};
    const Vec2 left_bottom{box.min.x, box.max.y};
    return {{box.min, right_top, box.max}, {box.min, box.max, left_bottom}};
}

/// A box as a cell with sharp edges.
std::shared_ptr<const Cell> box_cell(const Box& box) {
    return std::make_shared<const Cell>(Cell{.parts = {to_polygon(box)},
                                             .filler = {},
                                             .triangles = triangles_of(box),
                                             .filler_triangles = {},
                                             .fade_edges = {FadeEdge{}}});
}

/// A box as a cell whose edges fade into the surroundings.
std::shared_ptr<const Cell> soft_cell(const Box& box, double edge) {
    const Box inner{box.min + Vec2{edge, edge}, box.max - Vec2{edge, edge}};
    const Polygon corners = to_polygon(inner);
    FadeEdge fade;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int k = 0; k < edge_points; ++k)
            fade.outline.push_back(corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) *
                                                    (static_cast<double>(k) / edge_points));
    fade.widths.assign(fade.outline.size(), edge);
    return std::make_shared<const Cell>(Cell{.parts = {corners},
                                             .filler = {},
                                             .triangles = triangles_of(inner),
                                             .filler_triangles = {},
                                             .fade_edges = {fade},
                                             .edge_coverage = 1});
}

/// @param strip  the box of the strip
DrawItem tile_item(const TilePiece& piece, SourceId source, const Box& strip, double alpha) {
    const double width = (piece.right - piece.left) / (piece.last - piece.first);
    return {.source = source,
            .cell = box_cell({{piece.left, strip.min.y}, {piece.right, strip.max.y}}),
            .placement = {.scale = 1, .offset = {piece.left - piece.first * width, strip.min.y}},
            .picture = {width, strip.height()},
            .alpha = alpha};
}

DrawItem white_item(const DrawnTapestry& drawn, const Box& at, double alpha) {
    return {.source = drawn.sources.mark(),
            .cell = box_cell(at),
            .placement = {.scale = 1, .offset = at.min},
            .picture = {at.width(), at.height()},
            .alpha = alpha};
}

/// Draws one frame, part by part.
class Drawing {
  public:
    Drawing(const DrawnTapestry& drawn, nanoseconds now)
        : drawn_(drawn),
          place_(strip_place(drawn.tapestry, drawn.boxes)),
          frame_{.canvas = drawn.boxes.room.canvas, .idle = 1, .time = now} {}

    void draw_strip();
    void draw_coming();
    void draw_in_place();
    void draw_preview();
    void draw_playhead();

    Frame take_frame() { return std::move(frame_); }

  private:
    const Box& box() const { return drawn_.boxes.strip; }

    void draw_unwoven();
    void draw_level(std::size_t level, double alpha);
    void draw_above(const PlayingSpan& playing, nanoseconds local);
    void draw_cell(const PlacedCell& cell, const Box& at);
    void draw_time(nanoseconds time, double x);
    bool has_kept(nanoseconds moment) const;
    void draw_zoom(std::size_t level, bool is_to_finer);
    bool has_tiles(std::size_t level) const;
    bool has_zooms(std::size_t level) const;
    void cover_strip();

    /// The size of the film's whole picture, if the picture within its bars fills a box, canvas px.
    Vec2 picture_at(const Box& at) const { return whole_picture(drawn_.film, {at.width(), at.height()}); }

    /// The corner of that whole picture.
    Vec2 corner_at(const Box& at) const {
        const Vec2 bars = drawn_.film.active.min;
        const Vec2 picture = picture_at(at);
        return at.min - Vec2{bars.x * picture.x, bars.y * picture.y};
    }

    const DrawnTapestry& drawn_;
    TapestryPlace place_;
    Frame frame_;
};

void Drawing::draw_strip() {
    if (is_unwoven(drawn_.tapestry)) return draw_unwoven();
    const double level = drawn_.view.level;
    const auto coarse = static_cast<std::size_t>(level);
    const double share = level - static_cast<double>(coarse);
    if (share > 0 && drawn_.tapestry.levels[coarse + 1].has_zoom) {
        if (!has_tiles(coarse)) draw_level(0, 1);
        if (has_zooms(coarse)) cover_strip();
        draw_zoom(coarse, true);
        return draw_zoom(coarse + 1, false);
    }
    const double alpha = eased((share - blend_begin) / (blend_end - blend_begin));
    if (has_tiles(share > 0 && alpha >= 1 ? coarse + 1 : coarse))
        cover_strip();
    else
        draw_level(0, 1);
    if (alpha < 1) draw_level(coarse, 1);
    if (alpha > 0) draw_level(coarse + 1, alpha);
}

/// Draws a level's tiles between their places on this and on a neighbouring level.
void Drawing::draw_zoom(std::size_t level, bool is_to_finer) {
    const double share = drawn_.view.level - std::floor(drawn_.view.level);
    for (const auto& [tile, middle] : place_.tiles(drawn_.view, level, box().min.x, box().max.x)) {
        const std::shared_ptr<const ZoomMesh> mesh = drawn_.tiles.zoom(tile, is_to_finer);
        if (!mesh) continue;
        const Placement placement = place_.zoom_placement(drawn_.view, *mesh);
        const auto canvas_x = [&](double coarse, double fine) {
            const double x =
                (1 - share) * (coarse - mesh->coarse_origin) + share * (fine - mesh->fine_origin);
            return placement.offset.x + placement.scale * x;
        };
        if (canvas_x(mesh->coarse_left, mesh->fine_left) > box().max.x ||
            canvas_x(mesh->coarse_right, mesh->fine_right) < box().min.x)
            continue;
        const double tile_width = drawn_.tapestry.tile_width;
        const double width =
            std::min(tile_width, drawn_.tapestry.levels[level].width - tile.tile * tile_width);
        frame_.items.push_back({.source = drawn_.sources.tile(tile),
                                .cell = {},
                                .zoom = mesh,
                                .share = share,
                                .placement = placement,
                                .picture = {width, static_cast<double>(drawn_.tapestry.height)}});
    }
}

/// True if every tile in view on a level is loaded.
bool Drawing::has_tiles(std::size_t level) const {
    return std::ranges::all_of(place_.tiles(drawn_.view, level, box().min.x, box().max.x),
                               [&](const auto& tile) { return drawn_.tiles.has(tile.first); });
}

/// True if every tile in view on a level is loaded with its mesh to the finer level.
bool Drawing::has_zooms(std::size_t level) const {
    return std::ranges::all_of(
        place_.tiles(drawn_.view, level, box().min.x, box().max.x),
        [&](const auto& tile) { return drawn_.tiles.zoom(tile.first, true) != nullptr; });
}

/// Reports that the strip covers its box, as far as the film reaches.
void Drawing::cover_strip() {
    const double left = place_.canvas_x(drawn_.view, 0ns);
    const double right = place_.canvas_x(drawn_.view, drawn_.tapestry.duration);
    frame_.covered.push_back(intersection(box(), {{left, box().min.y}, {right, box().max.y}}));
}

void Drawing::draw_level(std::size_t level, double alpha) {
    for (const TilePiece& piece : place_.pieces(drawn_.view, level, box().min.x, box().max.x)) {
        if (drawn_.tiles.has(piece.tile))
            frame_.items.push_back(tile_item(piece, drawn_.sources.tile(piece.tile), box(), alpha));
    }
}

/// Draws what is loaded of a newer strip over the older one.
void Drawing::draw_coming() {
    if (!drawn_.coming) return;
    const OverlaidStrip& coming = *drawn_.coming;
    const TapestryPlace place = strip_place(*coming.tapestry, drawn_.boxes);
    const auto level = static_cast<std::size_t>(std::lround(coming.view.level));
    for (const TilePiece& piece : place.pieces(coming.view, level, box().min.x, box().max.x))
        if (coming.tiles->has(piece.tile))
            frame_.items.push_back(tile_item(piece, coming.sources.tile(piece.tile), box(), coming.alpha));
}

void Drawing::draw_unwoven() {
    const double left = std::max(box().min.x, place_.canvas_x(drawn_.view, 0ns));
    const double right = std::min(box().max.x, place_.canvas_x(drawn_.view, drawn_.tapestry.duration));
    frame_.items.push_back(white_item(drawn_, {{left, box().min.y}, {right, box().max.y}}, unwoven_alpha));
}

void Drawing::draw_in_place() {
    const std::optional<PlayingSpan>& playing = drawn_.preview.in_place();
    if (!playing || !playing->began) return;
    const nanoseconds local = frame_.time - *playing->began;
    const Box at = place_.brick(drawn_.view, drawn_.touched, drawn_.film.picture);
    const double alpha =
        eased(std::chrono::duration<double>(local) / std::chrono::duration<double>(appearing));
    frame_.items.push_back({.source = playing->source,
                            .cell = soft_cell(at, soft_edge * at.height()),
                            .placement = {.scale = 1, .offset = corner_at(at)},
                            .picture = picture_at(at),
                            .local = local,
                            .alpha = std::min(alpha, nearly_opaque)});
}

/// While a finger looks for a moment, the sharp picture or the kept frame is drawn, whichever is nearer to
/// the moment; until there is one, the film that has played before.
void Drawing::draw_preview() {
    const ScrubbedPicture& scrubbed = drawn_.preview.scrubbed();
    const std::optional<PlayingSpan>& sharp = scrubbed.sharp();
    if (scrubbed.moment() && has_kept(*scrubbed.moment())) {
        const KeptSheets& kept = drawn_.tapestry.kept;
        const nanoseconds away =
            std::chrono::abs(kept.times[kept.nearest(*scrubbed.moment())] - *scrubbed.moment());
        if (sharp &&
            std::chrono::abs(sharp->span.begin - *scrubbed.moment()) <= std::max<nanoseconds>(away, alike))
            return draw_above(*sharp, 0ns);
        frame_.covered.push_back(drawn_.boxes.preview);
        return draw_cell(placed_frame(drawn_.tapestry, *scrubbed.moment(), drawn_.boxes.preview),
                         drawn_.boxes.preview);
    }
    if (scrubbed.moment() && sharp) return draw_above(*sharp, 0ns);
    const std::optional<PlayingSpan>& playing = drawn_.preview.above();
    if (playing && playing->began) draw_above(*playing, drawn_.preview.time_above(frame_.time));
}

bool Drawing::has_kept(nanoseconds moment) const {
    return !drawn_.tapestry.kept.is_empty() &&
           drawn_.kept.has(placed_frame(drawn_.tapestry, moment, drawn_.boxes.preview).picture);
}

void Drawing::draw_cell(const PlacedCell& cell, const Box& at) {
    frame_.items.push_back({.source = drawn_.sources.tile(cell.picture),
                            .cell = box_cell(at),
                            .placement = {.scale = 1, .offset = cell.offset},
                            .picture = cell.size,
                            .alpha = 1});
}

/// Tells the film's time above its line, within the canvas.
void Drawing::draw_time(nanoseconds time, double x) {
    if (!drawn_.kept.has(digits_picture(drawn_.tapestry))) return;
    const std::string words = time_in_words(time);
    const DigitCells& digits = drawn_.tapestry.digits;
    const double high = std::round(digit_height * drawn_.boxes.room.screen.height());
    const double wide = std::round(high * digits.width / digits.height);
    const double all = wide * static_cast<double>(words.size());
    const double bottom = box().min.y - std::round(digit_gap * drawn_.boxes.room.screen.height());
    double left = std::max(box().min.x, std::min(std::round(x - all / 2), box().max.x - all));
    for (const char glyph : words) {
        const Box at{{left, bottom - high}, {left + wide, bottom}};
        draw_cell(placed_digit(drawn_.tapestry, glyph, at), at);
        left += wide;
    }
}

void Drawing::draw_above(const PlayingSpan& playing, nanoseconds local) {
    const Box& at = drawn_.boxes.preview;
    frame_.covered.push_back(at);
    frame_.items.push_back({.source = playing.source,
                            .cell = box_cell(at),
                            .placement = {.scale = 1, .offset = corner_at(at)},
                            .picture = picture_at(at),
                            .local = local,
                            .alpha = 1});
}

/// Draws a line through the strip at the time that the preview shows.
void Drawing::draw_playhead() {
    const std::optional<nanoseconds> time = drawn_.preview.playhead(frame_.time);
    if (!time) return;
    const double x = std::round(place_.canvas_x(drawn_.view, *time));
    const double half = std::max(1.0, std::round(drawn_.boxes.room.screen.height() / playhead_lines));
    if (x < box().min.x || x > box().max.x) return;
    draw_time(*time, x);
    const Box line{{x - half, box().min.y}, {x + half, box().max.y}};
    frame_.items.push_back(white_item(drawn_, line, playhead_alpha));
}

/// Lays a pale veil over the pictures of the nearest level that are struck; they are there until the tapestry
/// is woven anew.
void draw_struck(const DrawnTapestry& drawn, Frame& frame) {
    const TapestryPlace place = strip_place(drawn.tapestry, drawn.boxes);
    const auto level = static_cast<std::size_t>(std::lround(drawn.view.level));
    for (std::size_t k = 0; k < drawn.tapestry.levels[level].keyframes.size(); ++k) {
        const StripPicture picture{.time = drawn.tapestry.keyframe_time(level, k), .is_lower = k % 2 == 1};
        if (!is_struck(*drawn.edited, picture.time)) continue;
        const Box at = intersection(place.brick(drawn.view, picture, drawn.film.picture), place.box());
        if (at.max.x > at.min.x) frame.items.push_back(white_item(drawn, at, struck_alpha));
    }
}

/// A chosen moment has an upright bar below the strip, a struck one a dash.
void draw_edit(const DrawnTapestry& drawn, Frame& frame) {
    if (drawn.edited == nullptr) return;
    if (!is_unwoven(drawn.tapestry)) draw_struck(drawn, frame);
    const TapestryPlace place = strip_place(drawn.tapestry, drawn.boxes);
    const double high = drawn.boxes.room.screen.height();
    const double top = place.box().max.y + mark_gap * high;
    const auto draw_marks = [&](const std::vector<nanoseconds>& moments, Vec2 size) {
        for (const nanoseconds moment : moments) {
            const double x = place.canvas_x(drawn.view, moment);
            const double y = top + (mark_length * high - size.y) / 2;
            if (x < place.box().min.x || x > place.box().max.x) continue;
            const Box at{{x - size.x / 2, y}, {x + size.x / 2, y + size.y}};
            frame.items.push_back(white_item(drawn, at, playhead_alpha));
        }
    };
    draw_marks(drawn.edited->keyframes, {mark_width * high, mark_length * high});
    draw_marks(drawn.edited->struck, {mark_length * high, mark_width * high});
}

}  // namespace

TapestryBoxes tapestry_boxes(const TapestryRoom& room, Vec2 picture) {
    const Box& screen = room.screen;
    const double high = screen.height();
    const double height =
        std::min(preview_room * high, preview_width * screen.width() * picture.y / picture.x);
    const double half = height * picture.x / picture.y / 2;
    const double top = screen.min.y + preview_top * high + (preview_room * high - height) / 2;
    const double middle = screen.centre().x;
    return {.room = room,
            .strip = {{0, std::round(screen.min.y + strip_top * high)},
                      {room.canvas.x, std::round(screen.min.y + (strip_top + strip_height) * high)}},
            .preview = {{std::round(middle - half), std::round(top)},
                        {std::round(middle + half), std::round(top + height)}}};
}

TapestryPlace strip_place(const Tapestry& tapestry, const TapestryBoxes& boxes) {
    return {tapestry, boxes.strip, boxes.room.screen};
}

SourceId TapestrySources::tile(const TileId& tile) const {
    return first + (SourceId{generation} << generation_bit) + (SourceId{tile.level + 1} << level_bits) +
           static_cast<SourceId>(tile.tile);
}

SourceId TapestrySources::film() const {
    return first | film_bit;
}

Frame tapestry_frame(const DrawnTapestry& drawn, nanoseconds now) {
    Drawing drawing(drawn, now);
    drawing.draw_strip();
    drawing.draw_coming();
    drawing.draw_in_place();
    drawing.draw_preview();
    drawing.draw_playhead();
    Frame frame = drawing.take_frame();
    draw_edit(drawn, frame);
    return frame;
}

}  // namespace vitrine::player
