#include "player/stage/seen_files.hpp"

#include "player/display/screen.hpp"
#include "player/playback/source_pool.hpp"
#include "player/stage/stage.hpp"
#include "player/stage/stages.hpp"

#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_alpha = 0.5;  // a fainter picture is coming or leaving

}  // namespace

bool SeenFiles::is_seen(const Stage& stage, std::chrono::nanoseconds now) {
    if (stage.screens().empty()) return stage.is_seen();
    std::uint64_t count = 0;
    for (const Screen* screen : stage.screens())
        count += screen->flips();
    Flips& flips = flips_[stage.files().folder()];
    if (count != flips.count) flips = {.count = count, .changed = now};
    return count > 0 && now - flips.changed <= patience;
}

std::set<std::string> SeenFiles::look(const Stages& stages, const SourcePool& sources,
                                      std::chrono::nanoseconds now) {
    std::map<SourceId, std::string> paths;
    for (SourceState& source : sources.states())
        if (sources.sample(source.source)) paths.emplace(source.source, std::move(source.path));
    std::set<std::string> seen;
    for (const auto& stage : stages.all()) {
        if (!is_seen(*stage, now)) continue;
        for (const DrawItem& item : stage->frame().items)
            if (const auto path = paths.find(item.source); item.alpha >= min_alpha && path != paths.end())
                seen.insert(path->second);
    }
    return seen;
}

}  // namespace vitrine::player
