#include "player/scene/files/near_copies.hpp"

#include "base/state/path_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr int side = PicturePrint::side;
constexpr double min_contrast =
    4;  // mean deviation of the shades; plainer pictures have no pattern to compare

constexpr double min_pattern_likeness = 0.7;

/// A way to lay one picture over another: its places are centre + scale * (place - 0.5), all in shares of
/// the sides.
struct Fit {
    Vec2 centre{0.5, 0.5};
    Vec2 scale{1, 1};
};

Vec2 place_in_other(const Fit& fit, Vec2 place) {
    return {fit.centre.x + fit.scale.x * (place.x - 0.5), fit.centre.y + fit.scale.y * (place.y - 0.5)};
}

bool is_in_picture(Vec2 place) {
    return place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1;
}

/// The middle of a cell of a grid over the picture.
Vec2 cell_middle(int column, int row, int grid) {
    return {(column + 0.5) / grid, (row + 0.5) / grid};
}

double shade_at(const PicturePrint& print, Vec2 place) {
    const double column = std::clamp(place.x * side - 0.5, 0.0, side - 1.0);
    const double row = std::clamp(place.y * side - 0.5, 0.0, side - 1.0);
    const int left = std::min(side - 2, static_cast<int>(column));
    const int top = std::min(side - 2, static_cast<int>(row));
    const double right = column - left;
    const double down = row - top;
    const std::uint8_t* const at = print.shades.data() + std::ptrdiff_t{top} * side + left;
    return (at[0] * (1 - right) + at[1] * right) * (1 - down) +
           (at[side] * (1 - right) + at[side + 1] * right) * down;
}

/// The shades of a picture at a grid of places.
struct GridShades {
    GridShades(const PicturePrint& print, int grid) : points(grid) {
        for (int row = 0; row < points; ++row)
            for (int column = 0; column < points; ++column)
                shades.push_back(shade_at(print, cell_middle(column, row, points)));
    }

    int points;  // a side of the grid
    std::vector<double> shades;
};

/// The correlation of two pictures that lie over each other, where both are.
double correlation(const GridShades& a, const PicturePrint& b, const Fit& fit) {
    const int points = a.points;
    constexpr double min_overlap = 0.5;
    double n = 0, sum_a = 0, sum_b = 0, squares_a = 0, squares_b = 0, products = 0;
    for (int row = 0; row < points; ++row)
        for (int column = 0; column < points; ++column) {
            const Vec2 there = place_in_other(fit, cell_middle(column, row, points));
            if (!is_in_picture(there)) continue;
            const double one = a.shades[static_cast<std::size_t>(row) * static_cast<std::size_t>(points) +
                                        static_cast<std::size_t>(column)];
            const double other = shade_at(b, there);
            n += 1;
            sum_a += one;
            sum_b += other;
            squares_a += one * one;
            squares_b += other * other;
            products += one * other;
        }
    if (n < min_overlap * points * points) return -1;
    const double spread_a = squares_a - sum_a * sum_a / n, spread_b = squares_b - sum_b * sum_b / n;
    const double min_spread = n * min_contrast * min_contrast;
    if (spread_a < min_spread || spread_b < min_spread) return -1;
    return (products - sum_a * sum_b / n) / std::sqrt(spread_a * spread_b);
}

/// The shades of two pictures at a place where both are.
struct SharedPlace {
    Vec2 at;  // in the first picture
    double one = 0, other = 0;
};

/// Takes the gradient out of the shades: they are relative to a plane through them afterwards.
/// @param places  a grid in a rectangle
void remove_gradient(std::vector<SharedPlace>& places, double SharedPlace::*shade) {
    const auto count = static_cast<double>(places.size());
    Vec2 middle;
    double mean = 0;
    for (const SharedPlace& place : places) {
        middle = middle + place.at * (1 / count);
        mean += place.*shade / count;
    }
    Vec2 squares, slope;
    for (const SharedPlace& place : places) {
        const Vec2 away = place.at - middle;
        squares = squares + Vec2{away.x * away.x, away.y * away.y};
        slope = slope + away * (place.*shade);
    }
    for (SharedPlace& place : places) {
        const Vec2 away = place.at - middle;
        place.*shade -= mean + slope.x / squares.x * away.x + slope.y / squares.y * away.y;
    }
}

/// The correlation of two pictures that lie over each other, without their gradients: one sky is like
/// another.
double pattern_likeness(const PicturePrint& a, const PicturePrint& b, const Fit& fit) {
    std::vector<SharedPlace> places;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const Vec2 at = cell_middle(column, row, side);
            const Vec2 there = place_in_other(fit, at);
            if (is_in_picture(there))
                places.push_back({.at = at, .one = shade_at(a, at), .other = shade_at(b, there)});
        }
    remove_gradient(places, &SharedPlace::one);
    remove_gradient(places, &SharedPlace::other);
    double squares_a = 0, squares_b = 0, products = 0;
    for (const SharedPlace& place : places) {
        squares_a += place.one * place.one;
        squares_b += place.other * place.other;
        products += place.one * place.other;
    }
    return squares_a > 0 && squares_b > 0 ? products / std::sqrt(squares_a * squares_b) : 0;
}

struct RatedFit {
    double likeness = -1;
    Fit fit;
};

/// The best of a grid of fits.
RatedFit coarse_fit(const PicturePrint& a, const PicturePrint& b) {
    const GridShades shades(a, 8);
    constexpr std::array scales{0.78, 0.88, 1.0, 1.13, 1.28};
    constexpr std::array shifts{-0.1, -0.05, 0.0, 0.05, 0.1};
    RatedFit best;
    for (const double scale : scales)
        for (const double right : shifts)
            for (const double down : shifts) {
                const Fit fit{.centre = {0.5 + right, 0.5 + down}, .scale = {scale, scale}};
                const double rated = correlation(shades, b, fit);
                if (rated > best.likeness) best = {.likeness = rated, .fit = fit};
            }
    return best;
}

/// Climbs from a fit to the best one near it, in ever smaller steps.
RatedFit refined(const PicturePrint& a, const PicturePrint& b, const Fit& from) {
    const GridShades shades(a, side);
    RatedFit best{.likeness = correlation(shades, b, from), .fit = from};
    for (const double step : {0.03, 0.012}) {
        for (int round = 0; round < 3; ++round) {
            const double before = best.likeness;
            for (const double by : {-step, step})
                for (int which = 0; which < 4; ++which) {
                    Fit fit = best.fit;
                    (which == 0   ? fit.centre.x
                     : which == 1 ? fit.centre.y
                     : which == 2 ? fit.scale.x
                                  : fit.scale.y) += by;
                    const double rated = correlation(shades, b, fit);
                    if (rated > best.likeness) best = {.likeness = rated, .fit = fit};
                }
            if (best.likeness == before) break;
        }
    }
    return best;
}

/// The fit at which two photos are most alike, after a shift or a crop of up to a quarter. Its likeness is 1
/// where they differ by exposure only, and near 0 where they have nothing in common.
/// @param wanted  a likeness below it may be too low
RatedFit best_fit(const PicturePrint& a, const PicturePrint& b, double wanted) {
    constexpr double max_gain = 0.12;  // of the search around the best of the grid
    const RatedFit coarse = coarse_fit(a, b);
    if (coarse.likeness < wanted - max_gain) return coarse;
    return refined(a, b, coarse.fit);
}

/// The fit that lays the second picture over the first one.
Fit inverse(const Fit& fit) {
    const Vec2 scale{1 / fit.scale.x, 1 / fit.scale.y};
    return {.centre = {0.5 + (0.5 - fit.centre.x) * scale.x, 0.5 + (0.5 - fit.centre.y) * scale.y},
            .scale = scale};
}

using Shares = std::array<double, 3>;

/// The shares of red, green and blue at a place, between the fields of a look: exposure does not change them.
Shares colour_at(const ShotLook& look, Vec2 place) {
    constexpr int grid = ShotLook::grid;
    const double column = std::clamp(place.x * grid - 0.5, 0.0, grid - 1.0);
    const double row = std::clamp(place.y * grid - 0.5, 0.0, grid - 1.0);
    const int left = std::min(grid - 2, static_cast<int>(column));
    const int top = std::min(grid - 2, static_cast<int>(row));
    const auto channel = [&](int x, int y, std::size_t c) {
        return 1.0 +
               look.colours.at((static_cast<std::size_t>(y) * grid + static_cast<std::size_t>(x)) * 3 + c);
    };
    Shares shares{};
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double upper = std::lerp(channel(left, top, c), channel(left + 1, top, c), column - left);
        const double lower =
            std::lerp(channel(left, top + 1, c), channel(left + 1, top + 1, c), column - left);
        shares.at(c) = std::lerp(upper, lower, row - top);
        sum += shares.at(c);
    }
    for (double& share : shares)
        share /= sum;
    return shares;
}

/// The distances of the colours of two pictures in the fields of a look.
struct ColourDistance {
    double mean = 0;
    double max_of_field = 0;  // one thing in another colour
};

/// @param fit  lays the second picture over the first one
ColourDistance colour_distance(const ShotLook& a, const ShotLook& b, const Fit& fit) {
    constexpr int grid = ShotLook::grid;
    if (fit.scale.x * fit.scale.y > 1) return colour_distance(b, a, inverse(fit));
    ColourDistance distance;
    for (int row = 0; row < grid; ++row)
        for (int column = 0; column < grid; ++column) {
            const Vec2 place = cell_middle(column, row, grid);
            const Shares one = colour_at(a, place);
            const Shares other = colour_at(b, place_in_other(fit, place));
            double field = 0;
            for (std::size_t c = 0; c < one.size(); ++c)
                field += std::abs(one.at(c) - other.at(c)) / 3;
            distance.mean += field / (grid * grid);
            distance.max_of_field = std::max(distance.max_of_field, field);
        }
    return distance;
}

/// True where nothing has another colour when the second picture lies over the first one.
bool are_coloured_alike(const ShotLook& a, const ShotLook& b, const Fit& fit, Kinship kinship) {
    const ColourDistance limit = kinship == Kinship::unknown
                                     ? ColourDistance{.mean = 0.045, .max_of_field = 0.14}
                                     : ColourDistance{.mean = 0.06, .max_of_field = 0.2};
    const ColourDistance distance = colour_distance(a, b, fit);
    return distance.mean <= limit.mean && distance.max_of_field <= limit.max_of_field;
}

/// The hash of a part of a picture, as that of a look.
std::uint64_t part_hash(const PicturePrint& print, const Fit& part) {
    constexpr int steps = ShotLook::hash_side;
    std::uint64_t hash = 0;
    for (int row = 0; row < steps; ++row) {
        double before = 0;
        for (int column = 0; column <= steps; ++column) {
            const Vec2 place{(column + 0.5) / (steps + 1), (row + 0.5) / steps};
            const double shade = shade_at(print, place_in_other(part, place));
            if (column > 0) hash = hash << 1U | static_cast<unsigned>(before > shade);
            before = shade;
        }
    }
    return hash;
}

/// True where one picture can be a crop of the other: prints know no ratio of the sides.
bool are_shaped_alike(const MediaRecord& a, const MediaRecord& b) {
    constexpr double max_ratio = 1.8;  // a crop by a quarter along either side
    const double ratio = static_cast<double>(a.width) * b.height / (static_cast<double>(b.width) * a.height);
    return ratio <= max_ratio && ratio * max_ratio >= 1;
}

bool has_camera_time(const MediaRecord& record) {
    return record.origin.taken && record.origin.taken->source != TimeSource::file;
}

std::string_view folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

/// True where one name is the other with something behind it that is no number: "IMG_1 (1)", "IMG_1-edited".
bool is_copy_name(std::string_view a, std::string_view b) {
    if (a.size() > b.size()) std::swap(a, b);
    if (a.empty() || !b.starts_with(a)) return false;
    return a.size() == b.size() || b[a.size()] < '0' || b[a.size()] > '9';
}

std::chrono::milliseconds between(const TimeTaken& a, const TimeTaken& b) {
    return std::chrono::abs(a.at - b.at);
}

}  // namespace

std::string_view stem_of(std::string_view path) {
    path.remove_prefix(std::min(path.size(), path.rfind('/') + 1));
    const std::size_t dot = path.rfind('.');
    return dot == 0 ? path : path.substr(0, dot);
}

PhotoFacts facts_of(const MediaRecord& record) {
    PhotoFacts facts{.folder = folder_of(record.path), .stem = stem_of(record.path)};
    if (record.origin.taken) facts.taken = record.origin.taken->at.time_since_epoch();
    facts.has_camera_time = has_camera_time(record);
    return facts;
}

Kinship kinship(const PhotoFacts& a, const PhotoFacts& b) {
    const std::chrono::milliseconds time = a.taken && b.taken ? std::chrono::abs(*a.taken - *b.taken) : 0ms;
    if (a.has_camera_time && b.has_camera_time) {
        if (time == 0ms) return Kinship::copies;
        if (time <= 3s) return Kinship::sequence;
        return time <= 2min ? Kinship::neighbours : Kinship::strangers;
    }
    if (a.folder == b.folder && is_copy_name(a.stem, b.stem)) return Kinship::copies;
    const bool is_unknown = a.has_camera_time || b.has_camera_time || time <= 24h;
    return is_unknown ? Kinship::unknown : Kinship::strangers;
}

CopyLimits copy_limits(Kinship kinship) {
    switch (kinship) {
    case Kinship::copies:
    case Kinship::sequence:
        return {.min_likeness = 0.8, .max_hash_distance = 44};
    case Kinship::neighbours:
        return {.min_likeness = 0.95, .max_hash_distance = 18};
    case Kinship::unknown:
        return {.min_likeness = 0.92, .max_hash_distance = 24};
    case Kinship::strangers:
        break;
    }
    return {};
}

PhotoHashes hashes_of(const Shot& shot) {
    constexpr double size = 0.875;
    constexpr std::array<Vec2, 5> centres{
        {{0.5, 0.5}, {0.44, 0.44}, {0.56, 0.44}, {0.44, 0.56}, {0.56, 0.56}}};
    PhotoHashes hashes{.whole = shot.look->hash};
    for (std::size_t i = 0; i < centres.size(); ++i)
        hashes.parts.at(i) = part_hash(*shot.print, {.centre = centres.at(i), .scale = {size, size}});
    return hashes;
}

int distance_between(const PhotoHashes& a, const PhotoHashes& b) {
    int least = std::popcount(a.whole ^ b.whole);
    for (std::size_t i = 0; i < a.parts.size(); ++i)
        least =
            std::min({least, std::popcount(a.parts.at(i) ^ b.whole), std::popcount(a.whole ^ b.parts.at(i))});
    return least;
}

bool may_be_copies(const Shot& a, const Shot& b, Kinship kinship) {
    constexpr double max_distance = 0.06;  // of colours, before the two are laid over each other
    return kinship != Kinship::unknown || colour_distance(*a.look, *b.look, {}).mean <= max_distance;
}

bool are_near_copies(const MediaRecord& a, const MediaRecord& b) {
    if (a.kind != MediaKind::photo || b.kind != MediaKind::photo || a.shots.empty() || b.shots.empty())
        return false;
    const Kinship kin = kinship(facts_of(a), facts_of(b));
    const double wanted = copy_limits(kin).min_likeness;
    const Shot& one = a.shots.front();
    const Shot& other = b.shots.front();
    if (!are_shaped_alike(a, b)) return false;
    if (wanted > 1 || !one.print || !other.print || !one.look || !other.look) return false;
    const RatedFit best = best_fit(*one.print, *other.print, wanted);
    if (best.likeness < wanted) return false;
    if (kin == Kinship::copies) return true;  // somebody may have given it other colours
    return are_coloured_alike(*one.look, *other.look, best.fit, kin) &&
           pattern_likeness(*one.print, *other.print, best.fit) >= min_pattern_likeness;
}

bool are_live_pair(const MediaRecord& photo, const MediaRecord& film) {
    if (photo.kind != MediaKind::photo || film.kind != MediaKind::film) return false;
    if (!photo.origin.content_id.empty() && !film.origin.content_id.empty())
        return photo.origin.content_id == film.origin.content_id;
    constexpr auto max_film = 6s;
    if (film.duration > max_film || folder_of(photo.path) != folder_of(film.path)) return false;
    if (lower_case(stem_of(photo.path)) != lower_case(stem_of(film.path))) return false;
    if (!photo.origin.taken || !film.origin.taken) return true;
    const std::chrono::milliseconds time = between(*photo.origin.taken, *film.origin.taken);
    if (!has_camera_time(photo) || !has_camera_time(film))
        return time <= 1min || has_camera_time(photo) != has_camera_time(film);
    constexpr std::chrono::milliseconds zone_step = 15min;  // where the photo's zone is only assumed
    const bool is_zone_known = photo.origin.taken->source == TimeSource::camera;
    const std::chrono::milliseconds rest = time % zone_step;
    return time <= max_film ||
           (!is_zone_known && time <= 14h && std::min(rest, zone_step - rest) <= max_film);
}

}  // namespace vitrine::player
