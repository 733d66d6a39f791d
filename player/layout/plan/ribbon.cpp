#include "player/layout/plan/ribbon.hpp"

#include "player/layout/plan/plan.hpp"

#include <algorithm>
#include <cmath>

// An extension is an ordinary plan on a window two screens wide. Its left half screen has firm items, so that
// the new ones fit to them. Its right half screen stays loose, so that the next ones fit to it. So no
// straight seam is visible where two extensions meet.

namespace vitrine::player {

namespace {

double middle_of(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre.x;
}

double right_of(const LayoutItem& item, const Placement& at) {
    return bounding_box(placed_region(item, at)).max.x;
}

Placement shifted(Placement at, double by) {
    at.offset.x += by;
    return at;
}

}  // namespace

std::size_t wanted_newcomers(const Ribbon& ribbon, std::size_t items_a_screen) {
    return ribbon.items.empty() ? 2 * items_a_screen : items_a_screen;
}

RibbonExtension extension(const Ribbon& ribbon, std::span<const LayoutItem> newcomers,
                          const PlanRequest& rules) {
    const double width = ribbon.screen.x;
    RibbonExtension next{.request = rules, .newcomers = {newcomers.begin(), newcomers.end()}};
    next.origin = std::max(0.0, ribbon.firm - width / 2);
    next.end = next.origin + 2 * width;
    next.request.canvas = {next.end - next.origin, ribbon.screen.y};
    next.request.items.clear();
    for (std::size_t i = 0; i < ribbon.items.size(); ++i) {
        const LayoutItem& item = ribbon.items[i];
        const Placement& at = ribbon.placements[i];
        if (item.region.empty() || right_of(item, at) <= next.origin) continue;
        next.items.push_back(i);
        PlanItem entry{.item = item};
        if (middle_of(item, at) < ribbon.firm) {
            entry.previous = shifted(at, -next.origin);
            entry.is_pinned = true;
        }
        next.request.items.push_back(std::move(entry));
    }
    for (const LayoutItem& item : newcomers)
        next.request.items.push_back({.item = item});
    return next;
}

Ribbon extended(const Ribbon& ribbon, const RibbonExtension& extension, const Layout& layout) {
    Ribbon next = ribbon;
    next.firm = extension.end - ribbon.screen.x / 2;
    next.end = extension.end;
    for (std::size_t k = 0; k < layout.placements.size(); ++k) {
        const Placement at = shifted(layout.placements[k], extension.origin);
        if (k >= extension.items.size()) {
            next.items.push_back(extension.newcomers[k - extension.items.size()]);
            next.placements.push_back(at);
        } else if (!extension.request.items[k].is_pinned) {
            next.placements[extension.items[k]] = at;
        }
    }
    return next;
}

Layout ribbon_layout(std::span<const LayoutItem> items, Vec2 screen, double width, const PlanRequest& rules) {
    Ribbon ribbon{.screen = screen};
    const double screens = std::max(1.0, width / screen.x);
    const auto a_screen = static_cast<std::size_t>(std::ceil(static_cast<double>(items.size()) / screens));
    std::size_t used = 0;
    while (used < items.size()) {
        std::size_t count = std::min(items.size() - used, wanted_newcomers(ribbon, a_screen));
        RibbonExtension next = extension(ribbon, items.subspan(used, count), rules);
        if (next.end >= width) {  // the last window takes all items that are left, and ends with the ribbon
            next = extension(ribbon, items.subspan(used), rules);
            next.end = width;
            next.request.canvas.x = next.end - next.origin;
            count = items.size() - used;
        }
        ribbon = extended(ribbon, next, plan(next.request));
        used += count;
    }
    double covered = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        covered += seat_of(items[i], ribbon.placements[i]).area;
    return {.canvas = {width, screen.y},
            .placements = ribbon.placements,
            .energy = 1 - covered / (width * screen.y),
            .is_final = true};
}

}  // namespace vitrine::player
