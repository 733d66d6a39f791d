#include "base/catalogue/record.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

namespace vitrine {

Box core(const MediaRecord& record, const Shot& shot) {
    const double seconds = std::chrono::duration<double>(shot.duration()).count();
    const Vec2 travel = shot.region.drift * seconds;
    const Vec2 size{static_cast<double>(record.width), static_cast<double>(record.height)};
    return {{std::max(0.0, -travel.x), std::max(0.0, -travel.y)},
            {size.x - std::max(0.0, travel.x), size.y - std::max(0.0, travel.y)}};
}

std::string record_id(const std::string& path) {
    return fmt::format("{:016x}", static_cast<std::uint64_t>(XXH3_64bits(path.data(), path.size())));
}

}  // namespace vitrine
