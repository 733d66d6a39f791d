#include "player/layout/plan/ribbon.hpp"

#include "player/layout/plan/plan.hpp"

#include <algorithm>
#include <cmath>

// An extension is an ordinary plan on a window two screens wide. Its left half screen holds what is firm, so
// the new ones fit to it; its right half screen stays loose, so that the next ones fit to them: no straight
// seam shows where two extensions meet.

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

std::size_t wanted_newcomers(const Strip& strip, std::size_t items_a_screen) {
    return strip.items.empty() ? 2 * items_a_screen : items_a_screen;
}

StripExtension extension(const Strip& strip, std::span<const LayoutItem> newcomers,
                         const PlanRequest& rules) {
    const double width = strip.screen.x;
    StripExtension next{.request = rules, .newcomers = {newcomers.begin(), newcomers.end()}};
    next.origin = std::max(0.0, strip.firm - width / 2);
    next.end = next.origin + 2 * width;
    next.request.canvas = {next.end - next.origin, strip.screen.y};
    next.request.items.clear();
    for (std::size_t i = 0; i < strip.items.size(); ++i) {
        const LayoutItem& item = strip.items[i];
        const Placement& at = strip.placements[i];
        if (item.region.empty() || right_of(item, at) <= next.origin) continue;
        next.items.push_back(i);
        PlanItem entry{.item = item};
        if (middle_of(item, at) < strip.firm) {
            entry.previous = shifted(at, -next.origin);
            entry.is_pinned = true;
        }
        next.request.items.push_back(std::move(entry));
    }
    for (const LayoutItem& item : newcomers)
        next.request.items.push_back({.item = item});
    return next;
}

Strip extended(const Strip& strip, const StripExtension& extension, const Layout& layout) {
    Strip next = strip;
    next.firm = extension.end - strip.screen.x / 2;
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

Layout strip_layout(std::span<const LayoutItem> items, Vec2 screen, double width, const PlanRequest& rules) {
    Strip strip{.screen = screen};
    const double screens = std::max(1.0, width / screen.x);
    const auto a_screen = static_cast<std::size_t>(std::ceil(static_cast<double>(items.size()) / screens));
    std::size_t used = 0;
    while (used < items.size()) {
        std::size_t count = std::min(items.size() - used, wanted_newcomers(strip, a_screen));
        StripExtension next = extension(strip, items.subspan(used, count), rules);
        if (next.end >= width) {  // the last: takes all that is left, and ends where the strip ends
            next = extension(strip, items.subspan(used), rules);
            next.end = width;
            next.request.canvas.x = next.end - next.origin;
            count = items.size() - used;
        }
        strip = extended(strip, next, plan(next.request));
        used += count;
    }
    double covered = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        covered += seat_of(items[i], strip.placements[i]).area;
    return {.canvas = {width, screen.y},
            .placements = strip.placements,
            .energy = 1 - covered / (width * screen.y),
            .is_final = true};
}

}  // namespace vitrine::player
