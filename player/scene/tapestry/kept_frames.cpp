#include "player/scene/tapestry/kept_frames.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr int looked_ahead = 2;   // sheets on both sides of the finger's
constexpr int seen_moments = 12;  // moments all over the view whose sheets are got ready
constexpr double seam = 1;  // px of a kept frame at its sides that are not drawn: its neighbours shine in
constexpr int glyphs = 11;  // the digits and a colon

/// A cell of a picture that is divided into equal cells.
struct Cells {
    Vec2 cell;       // px of one
    Vec2 all;        // their number across and down
    Vec2 number;     // of the cell, across and down
    double cut = 0;  // px at its sides that are not drawn
};

PlacedCell placed(const TileId& picture, const Cells& cells, const Box& box) {
    const Vec2 drawn = cells.cell - Vec2{2 * cells.cut, 2 * cells.cut};
    const Vec2 scale{box.width() / drawn.x, box.height() / drawn.y};
    const Vec2 first{cells.number.x * cells.cell.x + cells.cut, cells.number.y * cells.cell.y + cells.cut};
    return {.picture = picture,
            .offset = box.min - Vec2{first.x * scale.x, first.y * scale.y},
            .size = {cells.cell.x * cells.all.x * scale.x, cells.cell.y * cells.all.y * scale.y}};
}

}  // namespace

TileId kept_sheet(const Tapestry& tapestry, int sheet) {
    return {.level = tapestry.levels.size(), .tile = sheet};
}

TileId digits_picture(const Tapestry& tapestry) {
    return {.level = tapestry.levels.size() + 1, .tile = 0};
}

bool is_of_level(const Tapestry& tapestry, const TileId& tile) {
    return tile.level < tapestry.levels.size();
}

std::string file_of(const Tapestry& tapestry, const TileId& tile) {
    if (is_of_level(tapestry, tile)) return tapestry.tile_name(tile.level, tile.tile);
    return tile.level == tapestry.levels.size() ? tapestry.sheet_name(tile.tile) : tapestry.digits_name();
}

std::vector<TileId> wanted_pictures(const TapestryPlace& place, const TapestryView& view,
                                    const Tapestry& tapestry, std::optional<nanoseconds> moment) {
    std::vector<TileId> wanted;
    const auto want = [&](const TileId& picture) {
        if (wanted.size() < max_kept_pictures && std::ranges::find(wanted, picture) == wanted.end())
            wanted.push_back(picture);
    };
    if (tapestry.digits.width > 0) want(digits_picture(tapestry));
    if (tapestry.kept.is_empty()) return wanted;
    const auto sheet_of = [&](nanoseconds time) {
        return static_cast<int>(tapestry.kept.nearest(time) / tapestry.kept.frames_of_a_sheet());
    };
    for (int ahead = 0; moment && ahead <= looked_ahead; ++ahead)
        for (const int sheet : {sheet_of(*moment) + ahead, sheet_of(*moment) - ahead})
            if (sheet >= 0 && sheet < tapestry.kept.sheets()) want(kept_sheet(tapestry, sheet));
    const Box& box = place.box();
    for (int k = 0; k < seen_moments; ++k)
        want(kept_sheet(tapestry,
                        sheet_of(place.time_at(view, box.min.x + box.width() * (k + 0.5) / seen_moments))));
    return wanted;
}

PlacedCell placed_frame(const Tapestry& tapestry, nanoseconds moment, const Box& box) {
    const KeptSheets& kept = tapestry.kept;
    const auto frame = static_cast<int>(kept.nearest(moment));
    const int cell = frame % (kept.columns * kept.rows);
    const int row = cell / kept.columns;
    return placed(kept_sheet(tapestry, frame / (kept.columns * kept.rows)),
                  {.cell = {static_cast<double>(kept.width), static_cast<double>(kept.height)},
                   .all = {static_cast<double>(kept.columns), static_cast<double>(kept.rows)},
                   .number = {static_cast<double>(cell % kept.columns), static_cast<double>(row)},
                   .cut = std::min(kept.width, kept.height) > 4 * seam ? seam : 0},
                  box);
}

PlacedCell placed_digit(const Tapestry& tapestry, char glyph, const Box& box) {
    return placed(
        digits_picture(tapestry),
        {.cell = {static_cast<double>(tapestry.digits.width), static_cast<double>(tapestry.digits.height)},
         .all = {glyphs, 1},
         .number = {static_cast<double>(glyph - '0'), 0}},
        box);  // the colon follows the nine, here as in the picture
}

std::string time_in_words(nanoseconds time) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time).count();
    if (seconds >= 3600)
        return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace vitrine::player
