#include "player/scene/pan/pan_course.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vitrine::player {

double PanCourse::at(std::chrono::nanoseconds now) const {
    const double moved = view + speed * std::chrono::duration<double>(now - since).count();
    return std::min(moved, std::max(last, view));
}

std::chrono::nanoseconds PanCourse::time_of(double place) const {
    return since +
           std::chrono::nanoseconds(static_cast<std::int64_t>(std::llround((place - view) / speed * 1e9)));
}

}  // namespace vitrine::player
