#include "player/stage/stage_settings.hpp"

#include "base/media/colour.hpp"
#include "base/settings/output_words.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

SlotSettings slot_settings(const Settings& settings) {
    return {.count = settings.layout.slots,
            .order = settings.show.order,
            .seed = static_cast<std::uint64_t>(settings.layout.seed),
            .film = settings.show.film,
            .dwell = settings.show.dwell,
            .max_dwell = settings.show.longest};
}

CellStyle cell_style(const Settings& settings) {
    return {.gutter = settings.layout.gutter,
            .corner_radius = settings.layout.corner_radius,
            .feather = settings.layout.feather,
            .sample_spacing =
                settings.layout.cells == CellMethod::sampled ? settings.layout.sample_spacing : 0};
}

SourceOptions source_options(const Settings& settings, bool keeps_time) {
    return {.background = colour_named(settings.show.background).value_or(Colour{}),
            .keeps_time = keeps_time};
}

MediaPlaces media_places(const Settings& settings) {
    return {.media = settings.media.root, .store = settings.state.directory + "/store"};
}

View view_of(const Settings& settings, int width, int height) {
    const Margins margins = margins_named(settings.output.margins).value_or(Margins{});
    const auto pixels = [](const ScreenLength& length, int side) {
        const double max_length = side * 0.4;  // px; larger margins are meant for larger screens
        return static_cast<int>(std::lround(std::min(length.pixels + length.share * side, max_length)));
    };
    return {.rotation = rotation_of(settings.output.rotation),
            .left = pixels(margins.left, width),
            .top = pixels(margins.top, height),
            .right = pixels(margins.right, width),
            .bottom = pixels(margins.bottom, height)};
}

PlanRequest plan_request(const Settings& settings, Vec2 canvas) {
    return {.canvas = canvas,
            .seed = static_cast<std::uint64_t>(settings.layout.seed),
            .clearance = settings.layout.clearance,
            .max_scale = settings.layout.max_enlargement,
            .energy = settings.layout.energy,
            .order = settings.layout.order};
}

}  // namespace vitrine::player
