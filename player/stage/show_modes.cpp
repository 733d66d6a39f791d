#include "player/stage/show_modes.hpp"

#include "player/playback/source_events.hpp"
#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/acts/led_folder_wall.hpp"
#include "player/scene/acts/led_panning_wall.hpp"
#include "player/scene/acts/led_wall.hpp"
#include "player/scene/folders/folder_wall.hpp"
#include "player/scene/pan/panning_wall.hpp"
#include "player/scene/wall.hpp"
#include "player/stage/stage_settings.hpp"

#include <algorithm>
#include <array>

namespace vitrine::player {

namespace {

WallSettings wall_settings(const Settings& settings, SourceId last_source) {
    WallSettings wall{.slots = slot_settings(settings),
                      .transition = {.duration = settings.show.motion, .cells = cell_style(settings)},
                      .nests = settings.layout.folders == FolderMode::nested,
                      .is_calm = settings.show.calm,
                      .photos_drift = settings.show.photo_drift && !settings.show.calm,
                      .touch = {.seed = static_cast<std::uint64_t>(settings.layout.seed),
                                .clearance = settings.layout.clearance,
                                .max_scale = settings.layout.max_enlargement},
                      .idle = settings.input.idle,
                      .hint = settings.input.hint};
    wall.slots.last_source = last_source;
    return wall;
}

std::unique_ptr<Show> make_wall(const Settings& settings, const Canvas& canvas, SourceId last_source) {
    const WallSettings wall = wall_settings(settings, last_source);
    if (wall.nests) return std::make_unique<FolderWall>(canvas, wall);
    return std::make_unique<Wall>(canvas, wall);
}

std::unique_ptr<Show> make_led_wall(const Settings& settings, const Canvas& canvas, SourceId last_source) {
    WallSettings wall = wall_settings(settings, last_source);
    wall.lead = LedWall::lead;
    wall.touch_lead = LedWall::touch_lead;
    if (wall.nests) return std::make_unique<LedFolderWall>(canvas, wall);
    return std::make_unique<LedWall>(canvas, wall);
}

PanSettings pan_settings(const Settings& settings, SourceId last_source) {
    const SlotSettings slots = slot_settings(settings);
    return {.ribbon = {.order = slots.order,
                       .seed = slots.seed,
                       .items_a_screen = slots.count,
                       .cells = cell_style(settings),
                       .last_source = last_source},
            .speed = settings.show.pan_speed,
            .idle = settings.input.idle};
}

std::unique_ptr<Show> make_panning_wall(const Settings& settings, const Canvas& canvas,
                                        SourceId last_source) {
    return std::make_unique<PanningWall>(canvas, pan_settings(settings, last_source));
}

std::unique_ptr<Show> make_led_panning_wall(const Settings& settings, const Canvas& canvas,
                                            SourceId last_source) {
    return std::make_unique<LedPanningWall>(canvas, pan_settings(settings, last_source));
}

const std::array<ShowMode, 2>& show_modes() {
    static const std::array<ShowMode, 2> modes{
        {{.mode = WallMode::fit, .has_turns = true, .make = make_wall, .make_led = make_led_wall},
         {.mode = WallMode::pan,
          .has_turns = false,
          .make = make_panning_wall,
          .make_led = make_led_panning_wall}}};
    return modes;
}

}  // namespace

std::unique_ptr<Show> make_show(const Settings& settings, const Canvas& canvas, std::uint64_t owner) {
    const SourceId last_source = sources_of(owner);
    if (owner == 0 && settings.wall.role == WallRole::follow)
        return std::make_unique<FollowedWall>(canvas, last_source);
    const bool leads = owner == 0 && settings.wall.role == WallRole::lead && can_lead(settings);
    const ShowMode& mode = show_mode(settings);
    return (leads ? mode.make_led : mode.make)(settings, canvas, last_source);
}

bool can_lead(const Settings& settings) {
    return show_mode(settings).make_led != nullptr;
}

const ShowMode& show_mode(const Settings& settings) {
    const WallMode mode = settings.show.calm ? WallMode::fit : settings.layout.mode;
    const auto found = std::ranges::find(show_modes(), mode, &ShowMode::mode);
    return found == show_modes().end() ? show_modes().front() : *found;
}

}  // namespace vitrine::player
