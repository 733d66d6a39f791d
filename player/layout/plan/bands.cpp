#include "player/layout/plan/bands.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_band = 1;  // canvas px of a side of a band as the search knows it

/// A band as a search knows it: it keeps its clearance from this box by itself.
PlanItem band_item(const Box& band, double clearance) {
    const auto inset = [&](double side) {
        return std::clamp((side - min_band) / 2, 0.0, std::max(clearance, min_clearance) - min_clearance);
    };
    const Vec2 by{inset(band.width()), inset(band.height())};
    const Box box{band.min + by, band.max - by};
    return {.item = {.region = to_polygon(box), .core = band},
            .previous = Placement{},
            .is_pinned = true,
            .is_band = true};
}

}  // namespace

double covered_px(const PlanRequest& request, const Layout& layout) {
    double covered = 0;
    for (std::size_t i = 0; i < request.items.size(); ++i)
        covered += seat_of(request.items[i].item, layout.placements[i]).area;
    return covered;
}

bool is_under_band(const Canvas& canvas, const LayoutItem& item, const Placement& at) {
    if (canvas.bands.empty()) return false;
    const Polygon region = placed_region(item, at);
    return std::ranges::any_of(canvas.bands,
                               [&](const Box& band) { return area(clipped(region, band)) > 0; });
}

bool is_clear_of_bands(const PlanRequest& request, std::span<const Placement> placements) {
    if (request.canvas.bands.empty()) return true;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const PlanItem& item = request.items[i];
        if (has_pinned_place(item)) continue;
        if (is_under_band(request.canvas, item.item, placements[i])) return false;
    }
    return true;
}

PlanRequest with_bands(const PlanRequest& request) {
    PlanRequest with = request;
    for (const Box& band : request.canvas.bands)
        with.items.push_back(band_item(band, request.clearance));
    return with;
}

Layout without_bands(Layout layout, const PlanRequest& request) {
    layout.placements.resize(request.items.size());
    layout.energy = 1 - covered_px(request, layout) / (request.canvas.x * request.canvas.y);
    return layout;
}

PlanWatch without_bands(const PlanWatch& watch, const PlanRequest& request) {
    if (!watch.on_better) return watch;
    const auto tell = [&watch, &request](const Layout& layout) {
        const Layout told = without_bands(layout, request);
        if (is_clear_of_bands(request, told.placements)) watch.on_better(told);
    };
    return {.on_better = tell, .should_stop = watch.should_stop};
}

}  // namespace vitrine::player
