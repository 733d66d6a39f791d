#include "base/state/record.hpp"

#include "base/state/name_hash.hpp"

#include <algorithm>
#include <tuple>

namespace vitrine {

Box active_picture(const MediaRecord& record, const Shot& shot) {
    const Box whole{{0, 0}, {static_cast<double>(record.width), static_cast<double>(record.height)}};
    const Box active = shot.picture ? intersection(*shot.picture, whole) : whole;
    return active.is_empty() ? whole : active;
}

Box active_picture(const MediaRecord& record) {
    if (record.shots.empty()) return active_picture(record, {});
    Box all = active_picture(record, record.shots.front());
    for (const Shot& shot : record.shots)
        all = united(all, active_picture(record, shot));
    return all;
}

Box core(const MediaRecord& record, const Shot& shot) {
    const double seconds = std::chrono::duration<double>(shot.duration()).count();
    const Vec2 travel = shot.region.drift * seconds;
    const Box picture = active_picture(record, shot);
    return {picture.min + Vec2{std::max(0.0, -travel.x), std::max(0.0, -travel.y)},
            picture.max - Vec2{std::max(0.0, travel.x), std::max(0.0, travel.y)}};
}

bool is_grown_from(const MediaRecord& after, const MediaRecord& before) {
    const auto head = [](const MediaRecord& record) {
        return std::tie(record.path, record.kind, record.bytes, record.mtime_ns, record.state, record.width,
                        record.height);
    };
    const auto is_same = [](const Shot& a, const Shot& b) {
        return a.begin == b.begin && a.end == b.end && a.ends_with == b.ends_with && a.region == b.region &&
               a.picture == b.picture;
    };
    return head(after) == head(before) && after.shots.size() >= before.shots.size() &&
           std::equal(before.shots.begin(), before.shots.end(), after.shots.begin(), is_same);
}

bool is_outdated(const MediaRecord& record) {
    return record.state == MediaState::ready && std::ranges::any_of(record.shots, [](const Shot& shot) {
               return shot.analysis < Shot::current_analysis;
           });
}

std::string record_path(const std::filesystem::path& file, const std::filesystem::path& root) {
    const std::filesystem::path relative =
        std::filesystem::absolute(file).lexically_normal().lexically_relative(
            (std::filesystem::absolute(root) / "").lexically_normal());
    const bool is_inside = !relative.empty() && *relative.begin() != ".." && relative != ".";
    return is_inside ? relative.string() : file.string();
}

std::string record_id(const std::string& path) {
    return name_hash(path);
}

}  // namespace vitrine
