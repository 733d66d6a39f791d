#include "player/plan_command.hpp"

#include "base/state/catalogue.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "player/display/film_writer.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "player/layout/plan/ribbon.hpp"
#include "player/scene/files/file_groups.hpp"
#include "player/scene/wall_entries.hpp"
#include "player/stage/stage_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace vitrine::player {

namespace {

struct FirstWall {
    std::vector<NamedItem> items;
    std::vector<int> groups;  // one for each item
};

FirstWall first_wall(const Settings& settings, const std::filesystem::path& directory, int screens) {
    if (!std::filesystem::is_directory(directory))
        throw std::runtime_error(fmt::format("there is no catalogue '{}'", directory.string()));
    const std::vector<MediaRecord> records =
        Catalogue(directory).load([](const std::string& file, const std::string& reason) {
            log::warning("record '{}' unreadable, ignoring: {}", file, reason);
        });
    SlotSettings wanted = slot_settings(settings);
    wanted.count *= screens;
    WallEntries slots(wanted, settings.layout.folders == FolderMode::nested);
    FileGroups groups;
    groups.set_files(records);
    ShowHints hints;
    hints.groups = groups.groups();
    slots.set_catalogue(records, hints);
    FirstWall wall;
    for (const WallShot& shot : slots.shots()) {
        wall.items.push_back(
            {.path = shot.key.path, .shot = static_cast<std::size_t>(shot.key.shot), .item = shot.item});
        wall.groups.push_back(group_of(shot));
    }
    return wall;
}

/// Writes a film that shows each layout of the packing for a moment.
void write_film(const std::filesystem::path& path, const FirstWall& wall, std::vector<Layout> layouts,
                const CellStyle& style) {
    constexpr auto moment = std::chrono::milliseconds(80);
    if (layouts.empty()) return;
    const auto even = [](double length) { return static_cast<int>(length) / 2 * 2; };
    const Vec2 size = layouts.back().canvas;
    FilmWriter film(path, even(size.x), even(size.y), 25);
    std::chrono::nanoseconds time{0};
    for (Layout& layout : layouts) {
        const std::string svg = plan_svg(plan_result(wall.items, std::move(layout), style));
        film.add(drawn_svg(svg, even(size.x), even(size.y)), time);
        time += moment;
    }
    film.finish();
}

Layout wall_layout(const Settings& settings, const PlanOptions& options, const FirstWall& wall,
                   const PlanWatch& watch) {
    const Vec2 canvas{static_cast<double>(options.width), static_cast<double>(options.height)};
    PlanRequest request = plan_request(settings, canvas);
    if (options.wall_width > options.width) {
        std::vector<LayoutItem> items;
        for (const NamedItem& item : wall.items)
            items.push_back(item.item);
        return ribbon_layout(items, canvas, options.wall_width, request);
    }
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        request.items.push_back({.item = wall.items[i].item, .group = wall.groups[i]});
    return plan(request, watch);
}

}  // namespace

void write_plan(const Settings& settings, const PlanOptions& options) {
    const int screens = std::max(1, static_cast<int>(std::lround(1.0 * options.wall_width / options.width)));
    const FirstWall wall = first_wall(settings, options.catalogue, screens);
    std::vector<Layout> on_the_way;
    PlanWatch watch;
    if (options.film) watch.on_better = [&](const Layout& layout) { on_the_way.push_back(layout); };
    const Layout layout = wall_layout(settings, options, wall, watch);
    const PlanResult plan = plan_result(wall.items, layout, cell_style(settings));
    if (options.film) {
        on_the_way.insert(on_the_way.end(), 25, layout);
        write_film(*options.film, wall, std::move(on_the_way), cell_style(settings));
    }
    if (options.svg) replace_file(*options.svg, plan_svg(plan));
    if (options.json) replace_file(*options.json, plan_json(plan) + "\n");
    if (!options.svg && !options.json && !options.film) fmt::print("{}\n", plan_json(plan));
}

}  // namespace vitrine::player
