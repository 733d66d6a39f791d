#include "analyzer/explain/time_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::analyzer {
namespace {

using std::chrono::nanoseconds;

constexpr double bar_height = 30;
constexpr double tick_y = 46;
constexpr double legend_x = 360;  // px from the right
constexpr Ink plain_shot = 0xC9C4BD;
constexpr Ink shown_shot = 0x4A6FA5;
constexpr Ink dissolve = 0xE0A13A;
constexpr Ink fade = 0x2B2927;
constexpr Ink ink = 0x76726D;
constexpr Ink number_ink = 0xFFFFFF;
constexpr Ink hole = 0xECE9E5;

double seconds(nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// The round number of seconds that gives at most ten ticks.
double tick_step(double duration) {
    constexpr std::array<double, 15> steps{0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1200, 3600};
    for (const double step : steps) {
        if (duration / step <= 10) return step;
    }
    return steps.back() * std::ceil(duration / steps.back() / 10);
}

Ink transition_colour(ShotEnd end) {
    if (end == ShotEnd::dissolve) return dissolve;
    return end == ShotEnd::fade ? fade : hole;
}

void draw_legend(Canvas& canvas, const Box& place) {
    double x = place.max.x - legend_x;
    constexpr std::array<std::pair<const char*, Ink>, 3> entries{
        {{"shown below", shown_shot}, {"dissolve", dissolve}, {"fade or black", fade}}};
    for (const auto& [name, colour] : entries) {
        canvas.fill({{x, place.min.y - 24}, {x + 12, place.min.y - 12}}, colour);
        x += 18 + canvas.text(name, {x + 18, place.min.y - 18}, {12, ink}) + 22;
    }
}

}  // namespace

std::string time_text(nanoseconds time) {
    const auto tenths = static_cast<long long>(std::llround(seconds(time) * 10));
    const long long s = tenths / 10;
    if (s < 60) return fmt::format("{}.{} s", s, tenths % 10);
    if (s < 3600) return fmt::format("{}:{:02}.{}", s / 60, s % 60, tenths % 10);
    return fmt::format("{}:{:02}:{:02}.{}", s / 3600, s / 60 % 60, s % 60, tenths % 10);
}

void draw_time_line(Canvas& canvas, const Box& place, const MediaRecord& record,
                    const std::vector<ShotEvidence>& rows) {
    const double duration = std::max(1e-3, seconds(record.duration));
    const auto at = [&](nanoseconds t) {
        return place.min.x + place.width() * std::min(1.0, seconds(t) / duration);
    };
    const double bottom = place.min.y + bar_height;
    canvas.fill({place.min, {place.max.x, bottom}}, hole);
    for (std::size_t i = 0; i < record.shots.size(); ++i) {
        const Shot& shot = record.shots[i];
        const nanoseconds next = i + 1 < record.shots.size() ? record.shots[i + 1].begin : record.duration;
        canvas.fill({{at(shot.end), place.min.y}, {at(next), bottom}}, transition_colour(shot.ends_with));
        const bool is_shown =
            std::any_of(rows.begin(), rows.end(), [&](const auto& r) { return r.shot == shot; });
        const double right = std::max(at(shot.begin) + 1, at(shot.end) - 1);
        canvas.fill({{at(shot.begin), place.min.y}, {right, bottom}}, is_shown ? shown_shot : plain_shot);
        const std::string number = fmt::format("{}", i + 1);
        const int width = canvas.text_width(number, 12);
        if (right - at(shot.begin) < width + 8) continue;
        canvas.text(number, {at(shot.begin) + 5, place.min.y + bar_height / 2}, {12, number_ink});
    }
    const double step = tick_step(duration);
    const int ticks = static_cast<int>(duration / step + 1e-9);
    for (int i = 0; i <= ticks; ++i) {
        const double t = i * step;
        const double x = place.min.x + place.width() * t / duration;
        canvas.fill({{x, bottom + 2}, {x + 1, bottom + 7}}, ink);
        const std::string label = time_text(nanoseconds(static_cast<long long>(t * 1e9)));
        const int width = canvas.text_width(label, 12);
        const double left = std::clamp(x - width / 2.0, place.min.x, place.max.x - width);
        canvas.text(label, {left, place.min.y + tick_y}, {12, ink});
    }
    draw_legend(canvas, place);
}

}  // namespace vitrine::analyzer
