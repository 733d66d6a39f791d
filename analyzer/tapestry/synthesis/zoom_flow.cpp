#include "analyzer/tapestry/synthesis/zoom_flow.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace vitrine::analyzer {

namespace {

constexpr int rows = ZoomField::rows;
constexpr int step = ZoomField::step;
constexpr int part_width = 512;       // px of the coarser strip
constexpr int margin = 64;            // px by which a part reaches beyond its used columns
constexpr int max_fine_width = 4096;  // px of the finer strip that are searched at once
constexpr int min_part_width = 64;    // px
constexpr int sampling = 2;           // px between the samples of an island
constexpr int min_samples = 15;       // samples, of about 60 around a point, that give it to an island
constexpr int height_squares = 8;     // the square of the height over the area of the smallest island
constexpr int smoothings = 24;        // rounds
constexpr double min_slope = 0.02;    // px of the other strip for each px, before the bounds of time apply
constexpr double min_drop = 0.5;      // px between two rows

}  // namespace

/// The motion of one pixel of an island, which counts for the point nearest to it.
struct ZoomFlow::Sample {
    std::size_t point = 0;
    int island = 0;
    Vec2 way;
};

double ZoomFlow::Grid::x(int column) const {
    return column + 1 == columns ? width : column * step;
}

std::size_t ZoomFlow::Grid::number(int column, int row) const {
    return as_index(row) * as_index(columns) + as_index(column);
}

ZoomFlow::ZoomFlow(const Tapestry& tapestry, std::size_t finer)
    : tapestry_(tapestry), finer_(finer), coarse_(grid(finer - 1, finer)), fine_(grid(finer, finer - 1)) {
    assert(tapestry.tile_width % step == 0);
    const auto& coarse = tapestry.levels[finer - 1].keyframes;
    const auto& fine = tapestry.levels[finer].keyframes;
    from_.assign(fine.size(), -1);
    for (std::size_t k = 0; k < coarse.size(); ++k) {
        const auto found = std::ranges::lower_bound(fine, coarse[k]) - fine.begin();
        kept_.push_back(std::min(static_cast<int>(found), static_cast<int>(fine.size()) - 1));
        from_[as_index(kept_.back())] = static_cast<int>(k);
    }
}

ZoomFlow::Grid ZoomFlow::grid(std::size_t level, std::size_t other) const {
    Grid grid{.level = level,
              .width = tapestry_.levels[level].width,
              .other_width = tapestry_.levels[other].width,
              .columns = ZoomField::columns_of(tapestry_.levels[level].width)};
    grid.points.resize(as_index(grid.columns) * as_index(rows));
    return grid;
}

std::vector<ZoomFlow::Part> ZoomFlow::parts() const {
    std::vector<Part> parts;
    const auto fine_x = [&](int x) {
        return static_cast<int>(tapestry_.x_at(finer_, tapestry_.time_at(finer_ - 1, x)));
    };
    for (int from = 0; from < coarse_.width;) {
        for (int width = part_width;; width /= 2) {
            const int to = std::min(from + width, coarse_.width);
            const cv::Range seen(std::max(0, from - margin), std::min(coarse_.width, to + margin));
            const cv::Range fine(std::max(0, fine_x(seen.start - tapestry_.brick_width)),
                                 std::min(fine_.width, fine_x(seen.end + tapestry_.brick_width) + 1));
            if (fine.size() > max_fine_width && width > min_part_width) continue;
            parts.push_back({.coarse = seen, .fine = fine, .used = {from, to}});
            from = to;
            break;
        }
    }
    return parts;
}

/// The keyframe whose brick lies at a place, in the row that is nearer.
int ZoomFlow::brick_at(cv::Point at, int keyframes) const {
    const int row = 2 * at.y < tapestry_.height ? 0 : 1;
    const int half = tapestry_.brick_width / 2;
    const int number = 2 * ((at.x - row * half) / tapestry_.brick_width) + row;
    return std::clamp(number, 0, keyframes - 1);
}

/// Guesses that a brick moves as a whole.
cv::Point ZoomFlow::to_fine(cv::Point at) const {
    const int brick = brick_at(at, static_cast<int>(kept_.size()));
    const double way = tapestry_.middle(finer_, as_index(kept_[as_index(brick)])) -
                       tapestry_.middle(finer_ - 1, as_index(brick));
    return {at.x + static_cast<int>(std::lround(way)), at.y};
}

/// Guesses that a brick moves as a whole; a new brick comes from the place of its time.
cv::Point ZoomFlow::to_coarse(cv::Point at) const {
    const int brick = brick_at(at, static_cast<int>(from_.size()));
    const int from = from_[as_index(brick)];
    if (from < 0)
        return {static_cast<int>(tapestry_.x_at(finer_ - 1, tapestry_.time_at(finer_, at.x))), at.y};
    const double way =
        tapestry_.middle(finer_ - 1, as_index(from)) - tapestry_.middle(finer_, as_index(brick));
    return {at.x + static_cast<int>(std::lround(way)), at.y};
}

Islands ZoomFlow::match(const Part& part, const cv::Mat& coarse, const cv::Mat& fine, const RunTasks& run) {
    const cv::Point coarse_begin(part.coarse.start, 0);
    const cv::Point fine_begin(part.fine.start, 0);
    IslandRules rules;
    rules.min_area = tapestry_.height * tapestry_.height / height_squares;
    Islands islands =
        find_islands(coarse, fine,
                     {.to_fine = [&](cv::Point at) { return to_fine(at + coarse_begin) - fine_begin; },
                      .to_coarse = [&](cv::Point at) { return to_coarse(at + fine_begin) - coarse_begin; }},
                     rules, run);
    const auto nearest = [&](const Grid& grid, cv::Point at) {
        const double gap = static_cast<double>(tapestry_.height) / (rows - 1);
        const int column = std::min(static_cast<int>(std::lround(at.x / double{step})), grid.columns - 1);
        return grid.number(column, std::min(static_cast<int>(std::lround(at.y / gap)), rows - 1));
    };
    std::vector<Sample> of_coarse;
    std::vector<Sample> of_fine;
    for (int y = 0; y < coarse.rows; y += sampling) {
        for (int x = part.used.start - part.coarse.start; x < part.used.end - part.coarse.start;
             x += sampling) {
            const int island = islands.number.at<int>(y, x);
            if (island == 0) continue;
            const cv::Vec2i place = islands.place.at<cv::Vec2i>(y, x);
            const cv::Point there = cv::Point(place[0], place[1]) + fine_begin;
            const cv::Point here = cv::Point(x, y) + coarse_begin;
            const Vec2 way{static_cast<double>(there.x - here.x), static_cast<double>(there.y - here.y)};
            of_coarse.push_back({.point = nearest(coarse_, here), .island = island, .way = way});
            of_fine.push_back({.point = nearest(fine_, there), .island = island, .way = way * -1});
        }
    }
    add(coarse_, std::move(of_coarse));
    add(fine_, std::move(of_fine));
    return islands;
}

/// Gives each point the motion of the island that covers most of its surroundings.
void ZoomFlow::add(Grid& grid, std::vector<Sample> samples) const {
    std::ranges::sort(samples, {},
                      [](const Sample& sample) { return std::tuple(sample.point, sample.island); });
    for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end) {
        Vec2 sum;
        for (; end < samples.size() && samples[end].point == samples[begin].point &&
               samples[end].island == samples[begin].island;
             ++end)
            sum = sum + samples[end].way;
        const int count = static_cast<int>(end - begin);
        Point& point = grid.points[samples[begin].point];
        if (count >= min_samples && count > point.samples)
            point = {.way = sum * (1.0 / count), .samples = count};
    }
}

void ZoomFlow::fill() {
    fill(coarse_);
    fill(fine_);
}

void ZoomFlow::fill(Grid& grid) const {
    spread(grid);
    smooth(grid);
    put_in_order(grid);
}

/// Fills each row linearly from one known point to the next. The ends of one strip go to the ends of the
/// other.
void ZoomFlow::spread(Grid& grid) const {
    grid.places.resize(grid.points.size());
    const double gap = static_cast<double>(tapestry_.height) / (rows - 1);
    for (int row = 0; row < rows; ++row) {
        grid.points[grid.number(0, row)] = {.way = {}, .samples = 1};
        grid.points[grid.number(grid.columns - 1, row)] = {
            .way = {static_cast<double>(grid.other_width - grid.width), 0}, .samples = 1};
        for (int last = 0, column = 0; column < grid.columns; ++column) {
            const Point& point = grid.points[grid.number(column, row)];
            if (point.samples == 0) continue;
            const Vec2 from = grid.points[grid.number(last, row)].way;
            for (int between = last; between <= column; ++between) {
                const double share =
                    column == last ? 0 : (grid.x(between) - grid.x(last)) / (grid.x(column) - grid.x(last));
                grid.places[grid.number(between, row)] =
                    Vec2{grid.x(between), row * gap} + from + (point.way - from) * share;
            }
            last = column;
        }
    }
}

/// Smooths the unknown points between the known ones.
void ZoomFlow::smooth(Grid& grid) const {
    const double gap = static_cast<double>(tapestry_.height) / (rows - 1);
    const auto way = [&](int column, int row) {
        return grid.places[grid.number(column, row)] - Vec2{grid.x(column), row * gap};
    };
    for (int round = 0; round < smoothings; ++round)
        for (int row = 0; row < rows; ++row)
            for (int column = 1; column + 1 < grid.columns; ++column) {
                if (grid.points[grid.number(column, row)].samples > 0) continue;
                const Vec2 mean =
                    (way(column - 1, row) + way(column + 1, row) + way(column, std::max(0, row - 1)) +
                     way(column, std::min(rows - 1, row + 1))) *
                    0.25;
                grid.places[grid.number(column, row)] = Vec2{grid.x(column), row * gap} + mean;
            }
}

/// The columns of the other strip between which a point must lie, px.
cv::Vec2d ZoomFlow::bounds(const Grid& grid, double x) const {
    const double brick = tapestry_.brick_width;
    if (grid.level == finer_) {
        const double middle = tapestry_.x_at(finer_ - 1, tapestry_.time_at(finer_, x));
        return {middle - brick, middle + brick};
    }
    return {tapestry_.x_at(finer_, tapestry_.time_at(finer_ - 1, x - brick)),
            tapestry_.x_at(finer_, tapestry_.time_at(finer_ - 1, x + brick))};
}

void ZoomFlow::put_in_order(Grid& grid) const {
    const auto x = [&](int column, int row) -> double& { return grid.places[grid.number(column, row)].x; };
    const auto y = [&](int column, int row) -> double& { return grid.places[grid.number(column, row)].y; };
    const int last = grid.columns - 1;
    for (int row = 0; row < rows; ++row) {
        x(0, row) = 0;
        x(last, row) = grid.other_width;
        for (int column = 1; column < last; ++column)
            x(column, row) = std::max(x(column, row), x(column - 1, row) + min_slope * step);
        for (int column = last - 1; column > 0; --column)
            x(column, row) = std::min(x(column, row), x(column + 1, row) - min_slope * step);
        for (int column = 1; column < last; ++column) {
            const cv::Vec2d bound = bounds(grid, grid.x(column));
            x(column, row) = std::clamp(x(column, row), std::max(0.0, bound[0]),
                                        std::min<double>(grid.other_width, bound[1]));
        }
    }
    for (int column = 0; column < grid.columns; ++column) {
        y(column, 0) = 0;
        y(column, rows - 1) = tapestry_.height;
        for (int row = 1; row + 1 < rows; ++row)
            y(column, row) = std::max(y(column, row), y(column, row - 1) + min_drop);
        for (int row = rows - 2; row > 0; --row)
            y(column, row) = std::min(y(column, row), y(column, row + 1) - min_drop);
    }
}

ZoomField ZoomFlow::field(int tile, bool is_to_finer) const {
    const Grid& grid = is_to_finer ? coarse_ : fine_;
    const int first = tile * tapestry_.tile_width / step;
    ZoomField field{.width = std::min(tapestry_.tile_width, grid.width - tile * tapestry_.tile_width),
                    .height = tapestry_.height,
                    .places = {},
                    .growths = {}};
    for (int row = 0; row < rows; ++row) {
        for (int column = first; column < first + field.columns(); ++column) {
            const int before = std::max(0, column - 1);
            const int after = std::min(grid.columns - 1, column + 1);
            field.places.push_back(grid.places[grid.number(column, row)]);
            field.growths.push_back(
                (grid.places[grid.number(after, row)].x - grid.places[grid.number(before, row)].x) /
                (grid.x(after) - grid.x(before)));
        }
    }
    return field;
}

double ZoomFlow::matched() const {
    const auto known = std::ranges::count_if(coarse_.points, [](const Point& p) { return p.samples > 1; });
    return static_cast<double>(known) / static_cast<double>(coarse_.points.size());
}

}  // namespace vitrine::analyzer
