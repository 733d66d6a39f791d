#include "tests/player/render/reference_idle.hpp"

#include <cmath>
#include <numbers>

namespace vitrine::player {

namespace {

constexpr int idle_columns = 40;
constexpr int idle_rows = 25;

struct Light {
    Rgb colour;
    double turns_x, turns_y;  // an hour
    double phase;
    double radius;
};

constexpr std::array<Light, 4> lights{{{{0.080, 0.220, 0.330}, 67, 53, 0.4, 0.55},
                                       {{0.260, 0.120, 0.300}, -47, 61, 2.3, 0.50},
                                       {{0.330, 0.170, 0.090}, 59, -43, 4.1, 0.36},
                                       {{0.050, 0.230, 0.190}, -71, -37, 5.5, 0.44}}};

Rgb idle_colour(Vec2 share, Vec2 canvas, double seconds) {
    const double turn = 2 * std::numbers::pi / 3600 * seconds;
    const double aspect = canvas.x / canvas.y;
    const Vec2 stretch = aspect > 1 ? Vec2{aspect, 1} : Vec2{1, 1 / aspect};
    Vec2 p{share.x * stretch.x, share.y * stretch.y};
    p = p + Vec2{std::sin(3.1 * p.y + turn * 83), std::sin(2.3 * p.x - turn * 73)} * 0.11;
    Rgb c{0.055 + (0.020 - 0.055) * share.y, 0.075 + (0.035 - 0.075) * share.y,
          0.150 + (0.075 - 0.150) * share.y};
    for (const Light& light : lights) {
        const Vec2 place{(0.5 + 0.42 * std::sin(turn * light.turns_x + light.phase)) * stretch.x,
                         (0.5 + 0.38 * std::cos(turn * light.turns_y + light.phase * 1.7)) * stretch.y};
        const Vec2 way = p - place;
        for (std::size_t i = 0; i < 3; ++i)
            c[i] += light.colour[i] * std::exp(-dot(way, way) / (light.radius * light.radius));
    }
    const double fold = dot(p, Vec2{2.9, 4.7}) + 1.4 * std::sin(1.7 * p.x - turn * 41) + turn * 97;
    for (double& channel : c)
        channel =
            channel * (1 + 0.38 * std::pow(0.5 + 0.5 * std::sin(fold), 3)) + 0.012 * std::sin(fold * 0.5 + 1);
    return c;
}

}  // namespace

std::vector<std::array<IdleCorner, 3>> idle_triangles(Vec2 canvas, std::chrono::nanoseconds time) {
    const double seconds = std::fmod(std::chrono::duration<double>(time).count(), 3600);
    const auto corner = [&](int column, int row) {
        const Vec2 share{static_cast<double>(column) / idle_columns, static_cast<double>(row) / idle_rows};
        return IdleCorner{.share = share, .colour = idle_colour(share, canvas, seconds)};
    };
    std::vector<std::array<IdleCorner, 3>> triangles;
    for (int row = 0; row < idle_rows; ++row)
        for (int column = 0; column < idle_columns; ++column) {
            const IdleCorner a = corner(column, row);
            const IdleCorner b = corner(column + 1, row);
            const IdleCorner c = corner(column, row + 1);
            triangles.push_back({a, b, c});
            triangles.push_back({b, corner(column + 1, row + 1), c});
        }
    return triangles;
}

}  // namespace vitrine::player
