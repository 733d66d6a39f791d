#include "player/stage/stage_settings.hpp"

#include "base/media/colour.hpp"
#include "base/settings/output_words.hpp"
#include "base/system/machine.hpp"
#include "player/scene/change_pace.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

/// The values, in canvas px, that a look gives to keys that are not written down.
struct LookSizes {
    double gutter;
    double corner_radius;
    double feather;
};

LookSizes sizes_of(WallLook look, CellMethod cells) {
    // Without a gutter round corners would leave holes, except round bends of taut seams.
    const double bend_radius = cells == CellMethod::taut ? 24 : 0;
    switch (look) {
    case WallLook::tiles:
        return {.gutter = 8, .corner_radius = 16, .feather = 1};
    case WallLook::soft:
        return {.gutter = 0, .corner_radius = bend_radius, .feather = 24};
    case WallLook::seamless:
        break;
    }
    return {.gutter = 0, .corner_radius = bend_radius, .feather = 1};
}

}  // namespace

SlotSettings slot_settings(const Settings& settings) {
    return {.count = settings.layout.slots,
            .order = settings.show.order,
            .seed = static_cast<std::uint64_t>(settings.layout.seed),
            .film = settings.show.film,
            .dwell = settings.show.dwell,
            .max_dwell = settings.show.longest,
            .spacing = settings.show.calm ? calm_spacing : SlotSettings{}.spacing};
}

std::chrono::nanoseconds change_spacing(const Settings& settings) {
    return settings.show.calm ? calm_spacing : flash_spacing;
}

CellStyle cell_style(const Settings& settings) {
    const Settings::Layout& layout = settings.layout;
    const LookSizes look = sizes_of(layout.look, layout.cells);
    const auto chosen = [](double written, double usual) { return written < 0 ? usual : written; };
    return {.is_taut = layout.cells == CellMethod::taut,
            .gutter = chosen(layout.gutter, look.gutter),
            .corner_radius = chosen(layout.corner_radius, look.corner_radius),
            .feather = std::max(1.0, chosen(layout.feather, look.feather)),
            .sample_spacing = layout.cells == CellMethod::sampled ? layout.sample_spacing : 0};
}

SourceOptions source_options(const Settings& settings, bool keeps_time) {
    return {.background = colour_named(settings.show.background).value_or(Colour{}),
            .keeps_time = keeps_time};
}

MediaPlaces media_places(const Settings& settings) {
    return {.media = settings.media.root, .store = settings.state.directory + "/store"};
}

std::string box_name(const Settings& settings) {
    if (!settings.wall.box.empty()) return settings.wall.box;
    const std::string host = host_name();
    return host.empty() ? "box" : host;
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

PlanRequest plan_request(const Settings& settings, const Canvas& canvas) {
    return {.canvas = canvas,
            .seed = static_cast<std::uint64_t>(settings.layout.seed),
            .clearance = std::max(settings.layout.clearance, cell_style(settings).gutter),
            .max_scale = settings.layout.max_enlargement,
            .energy = settings.layout.energy,
            .order = settings.layout.order,
            .neighbours = settings.layout.neighbours};
}

}  // namespace vitrine::player
