#pragma once

#include "base/settings/settings.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/playback/media_places.hpp"
#include "player/playback/shot_source.hpp"
#include "player/render/view.hpp"
#include "player/scene/wall_slots.hpp"

#include <chrono>
#include <string>

namespace vitrine::player {

// Converts the settings for the parts of a stage.

SlotSettings slot_settings(const Settings& settings);
CellStyle cell_style(const Settings& settings);

/// The least time between the begins of two changes.
std::chrono::nanoseconds change_spacing(const Settings& settings);

/// @param keeps_time  true: pictures are shown at their time and late ones are skipped; false: all are shown
SourceOptions source_options(const Settings& settings, bool keeps_time);

MediaPlaces media_places(const Settings& settings);

/// The name of this box in a wall of several boxes: the host's, if none is set.
std::string box_name(const Settings& settings);

/// The view of a canvas on a screen of this size, px.
View view_of(const Settings& settings, int width, int height);

/// A request without items.
PlanRequest plan_request(const Settings& settings, const Canvas& canvas);

}  // namespace vitrine::player
