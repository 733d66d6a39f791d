#include "player/plan_command.hpp"

#include "base/catalogue/catalogue.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "player/layout/plan_output.hpp"
#include "player/player_settings.hpp"
#include "player/scene/assemblage.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

namespace vitrine {

namespace {

std::vector<NamedItem> first_wall(const Settings& settings, const std::filesystem::path& directory) {
    if (!std::filesystem::is_directory(directory))
        throw std::runtime_error(fmt::format("there is no catalogue '{}'", directory.string()));
    const std::vector<MediaRecord> records =
        Catalogue(directory).load([](const std::string& file, const std::string& reason) {
            log::warning("record '{}' unreadable, ignoring: {}", file, reason);
        });
    Assemblage assemblage(assemblage_settings(settings));
    assemblage.set_catalogue(records);
    std::vector<NamedItem> items;
    for (const WallShot& shot : assemblage.wall())
        items.push_back(
            {.path = shot.key.path, .shot = static_cast<std::size_t>(shot.key.shot), .item = shot.item});
    return items;
}

}  // namespace

void write_plan(const Settings& settings, const PlanOptions& options) {
    const Vec2 canvas{static_cast<double>(options.width), static_cast<double>(options.height)};
    const PlanResult plan =
        plan_named(first_wall(settings, options.catalogue), plan_request(settings, canvas));
    if (options.svg) replace_file(*options.svg, plan_svg(plan));
    if (options.json) replace_file(*options.json, plan_json(plan) + "\n");
    if (!options.svg && !options.json) fmt::print("{}\n", plan_json(plan));
}

}  // namespace vitrine
