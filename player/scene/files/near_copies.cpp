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

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr int side = PicturePrint::side;
constexpr double min_contrast =
    4;  // mean deviation of the shades; plainer pictures have no pattern to compare

/// A way to lay one picture over another: its places are centre + scale * (place - 0.5), all in shares of
/// the sides.
struct Fit {
    Vec2 centre{0.5, 0.5};
    Vec2 scale{1, 1};
};

double shade_at(const PicturePrint& print, double x, double y) {
    const double column = std::clamp(x * side - 0.5, 0.0, side - 1.0);
    const double row = std::clamp(y * side - 0.5, 0.0, side - 1.0);
    const int left = std::min(side - 2, static_cast<int>(column));
    const int top = std::min(side - 2, static_cast<int>(row));
    const double right = column - left;
    const double down = row - top;
    const std::uint8_t* const at = print.shades.data() + std::ptrdiff_t{top} * side + left;
    return (at[0] * (1 - right) + at[1] * right) * (1 - down) +
           (at[side] * (1 - right) + at[side + 1] * right) * down;
}

/// The correlation of two pictures that lie over each other, where both are.
/// @param points  a side of the grid of places that are compared
double correlation(const PicturePrint& a, const PicturePrint& b, const Fit& fit, int points) {
    constexpr double min_overlap = 0.5;
    double n = 0, sum_a = 0, sum_b = 0, squares_a = 0, squares_b = 0, products = 0;
    for (int row = 0; row < points; ++row)
        for (int column = 0; column < points; ++column) {
            const double x = (column + 0.5) / points, y = (row + 0.5) / points;
            const double other_x = fit.centre.x + fit.scale.x * (x - 0.5);
            const double other_y = fit.centre.y + fit.scale.y * (y - 0.5);
            if (other_x < 0 || other_x > 1 || other_y < 0 || other_y > 1) continue;
            const double one = shade_at(a, x, y), other = shade_at(b, other_x, other_y);
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

struct RatedFit {
    double likeness = -1;
    Fit fit;
};

/// The best of a grid of fits.
RatedFit coarse_fit(const PicturePrint& a, const PicturePrint& b) {
    constexpr int points = 8;
    constexpr std::array scales{0.78, 0.88, 1.0, 1.13, 1.28};
    constexpr std::array shifts{-0.1, -0.05, 0.0, 0.05, 0.1};
    RatedFit best;
    for (const double scale : scales)
        for (const double right : shifts)
            for (const double down : shifts) {
                const Fit fit{.centre = {0.5 + right, 0.5 + down}, .scale = {scale, scale}};
                const double rated = correlation(a, b, fit, points);
                if (rated > best.likeness) best = {.likeness = rated, .fit = fit};
            }
    return best;
}

/// Climbs from a fit to the best one near it, in ever smaller steps.
RatedFit refined(const PicturePrint& a, const PicturePrint& b, const Fit& from) {
    RatedFit best{.likeness = correlation(a, b, from, side), .fit = from};
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
                    const double rated = correlation(a, b, fit, side);
                    if (rated > best.likeness) best = {.likeness = rated, .fit = fit};
                }
            if (best.likeness == before) break;
        }
    }
    return best;
}

/// The distance of the colours of two pictures, which exposure does not change: it compares the shares of
/// red, green and blue in 3 x 3 fields.
struct ColourDistance {
    double mean = 0;
    double max_of_field = 0;  // of the field that differs most: one thing in another colour
};

ColourDistance colour_distance(const ShotLook& a, const ShotLook& b) {
    ColourDistance distance;
    for (std::size_t i = 0; i < a.colours.size(); i += 3) {
        const auto sum = [&](const ShotLook& look) {
            return 3.0 + look.colours[i] + look.colours[i + 1] + look.colours[i + 2];
        };
        double field = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            field += std::abs((a.colours[c] + 1) / sum(a) - (b.colours[c] + 1) / sum(b)) / 3;
        distance.mean += field * 3 / static_cast<double>(a.colours.size());
        distance.max_of_field = std::max(distance.max_of_field, field);
    }
    return distance;
}

/// True where nothing has another colour.
bool are_coloured_alike(const ShotLook& a, const ShotLook& b) {
    constexpr double max_mean = 0.045;
    constexpr double max_field = 0.14;
    const ColourDistance distance = colour_distance(a, b);
    return distance.mean <= max_mean && distance.max_of_field <= max_field;
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

double likeness(const PicturePrint& a, const PicturePrint& b, double wanted) {
    constexpr double max_gain = 0.12;  // of the search around the best of the grid
    const RatedFit coarse = coarse_fit(a, b);
    if (coarse.likeness < wanted - max_gain) return coarse.likeness;
    return std::max(correlation(a, b, coarse.fit, side), refined(a, b, coarse.fit).likeness);
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
        return {.min_likeness = 0.95, .max_hash_distance = 28};
    case Kinship::unknown:
        return {.min_likeness = 0.92, .max_hash_distance = 30};
    case Kinship::strangers:
        break;
    }
    return {};
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
    if (kin == Kinship::unknown && !are_coloured_alike(*one.look, *other.look)) return false;
    return likeness(*one.print, *other.print, wanted) >= wanted;
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
