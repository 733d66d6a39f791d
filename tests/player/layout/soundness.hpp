#pragma once

#include "player/layout/pack/energy.hpp"
#include "player/layout/plan/plan_output.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace vitrine::player {

/// Draws a layout that failed into the working directory, which is the build's, and says where.
inline void leave_picture(const std::vector<LayoutItem>& items, const Layout& layout,
                          const std::string& name) {
    std::vector<NamedItem> named;
    for (const LayoutItem& item : items)
        named.push_back({name, named.size(), item});
    const std::filesystem::path file = std::filesystem::absolute(name + ".svg");
    std::ofstream(file) << plan_svg({.items = named, .layout = layout});
    MESSAGE("the layout is drawn in ", file.string());
}

/// True where all regions lie in the canvas and none covers another; leaves a picture where not.
inline bool is_sound(const std::vector<LayoutItem>& items, const Layout& layout, const std::string& name) {
    if (layout.placements.size() != items.size()) return false;
    if (items.empty()) return true;
    const Measure measure = measured(items, layout.placements);
    bool sound = measure.hidden == 0 && measure.bounds.min.x >= 0 && measure.bounds.min.y >= 0 &&
                 measure.bounds.max.x <= layout.canvas.x && measure.bounds.max.y <= layout.canvas.y;
    for (const Placement& placement : layout.placements)
        sound = sound && placement.scale > 0;
    if (!sound) leave_picture(items, layout, name);
    return sound;
}

}  // namespace vitrine::player
