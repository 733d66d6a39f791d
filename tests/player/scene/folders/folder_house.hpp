#pragma once

#include "player/layout/plan/plan.hpp"
#include "player/scene/folders/folder_wall.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// The player around a wall of folders, without files and screen: plans at once, sources are ready at once.
struct FolderHouse {
    std::unique_ptr<FolderWall> wall;
    std::chrono::nanoseconds now{0};
    std::map<SourceId, ShotRequest> playing{};
    std::set<std::string> answers_late{};  // paths of files whose sources are not ready
    std::int64_t budget = 2'000;
    WallStep last{};

    explicit FolderHouse(const std::vector<MediaRecord>& records, int slots = 12,
                         ShotOrder order = ShotOrder::name)
        : wall(std::make_unique<FolderWall>(
              canvas(), WallSettings{.slots = {.count = slots, .order = order}, .nests = true})) {
        wall->set_catalogue(records);
    }

    static Vec2 canvas() { return {1280, 720}; }

    void lay_out(const WallPlan& wanted) {
        Layout layout{.canvas = wanted.canvas};
        if (wanted.way) {
            layout.way = std::make_shared<const WallWay>(way_to(*wanted.way));
            layout.placements = layout.way->keys.back().placements;
        } else {
            layout = plan({.items = wanted.items,
                           .canvas = wanted.canvas,
                           .budget = budget,
                           .max_scale = 4,
                           .keeps_places = wanted.keeps_places});
        }
        layout.generation = wanted.generation;
        layout.is_final = true;
        wall->set_layout(layout);
    }

    const WallStep& step() {
        last = wall->step(now);
        for (const ShotRequest& request : last.requests) {
            playing[request.source] = request;
            if (!answers_late.contains(request.path)) wall->source_ready(request.source);
        }
        for (const SourceId source : last.retired)
            REQUIRE(playing.erase(source) == 1);
        for (const DrawItem& item : last.frame.items)
            REQUIRE(playing.contains(item.source));
        if (last.plan) lay_out(*last.plan);
        now += std::chrono::milliseconds(50);
        return last;
    }

    void run(std::chrono::nanoseconds duration, const std::function<void()>& each = {}) {
        for (const auto end = now + duration; now < end;) {
            step();
            if (each) each();
        }
    }

    /// A tap on the first shot of an entry that is seen. False: there is none.
    bool tap(const std::string& path) {
        for (const auto& [source, request] : playing) {
            if (request.path != path && !request.path.starts_with(path + '/')) continue;
            for (const DrawItem& item : last.frame.items) {
                if (item.source != source || item.alpha < 1) continue;
                const Vec2 at = centroid(item.cell->parts.front());
                const auto seen = wall->shot_at(at);
                if (!seen || seen->source != source) continue;
                wall->handle_gesture({.kind = Gesture::Kind::tap, .subject = source, .at = at, .from = at});
                return true;
            }
        }
        return false;
    }

    void tap_at(Vec2 at) { wall->handle_gesture({.kind = Gesture::Kind::tap, .at = at, .from = at}); }

    void go_back() { wall->handle_gesture({.kind = Gesture::Kind::key, .key = Key::back}); }
};

/// Files of a folder.
inline void add_files(std::vector<MediaRecord>& records, const std::string& folder, int count) {
    for (int i = 0; i < count; ++i)
        records.push_back(photo(folder + "/p" + std::to_string(100 + i)));
}

}  // namespace vitrine::player
