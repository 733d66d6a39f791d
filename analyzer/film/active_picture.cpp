#include "analyzer/film/active_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <span>
#include <utility>

namespace vitrine::analyzer {

namespace {

using Depths = std::array<int, 4>;

constexpr int same_colour = 14;        // largest difference of a channel within a band: noise of a coder
constexpr int other_colour = 18;       // smallest difference of a channel at the inner edge
constexpr double max_strays = 0.01;    // share of a row that may have another colour
constexpr int edge_rows = 3;           // rows behind a band in which its edge is looked for: scaling blurs it
constexpr double min_depth = 0.01;     // share of the picture's side; a thinner band is left alone
constexpr double max_bars = 0.65;      // share of the picture's side that two bars may take
constexpr double min_edges = 0.08;     // share of a shot's pictures in which the edge is seen
constexpr double max_glitches = 0.02;  // share of a shot's pictures that may have a narrower band
constexpr int black = 44;              // largest channel of black as tapes have it
constexpr int place_tolerance = 1;     // px between the depths of one band in two pictures

int difference(const cv::Vec3b& a, const cv::Vec3b& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The median of each channel in a row.
cv::Vec3b row_colour(const cv::Mat& picture, int row) {
    cv::Vec3b median;
    std::vector<unsigned char> values(static_cast<std::size_t>(picture.cols));
    for (int channel = 0; channel < 3; ++channel) {
        for (int x = 0; x < picture.cols; ++x)
            values[static_cast<std::size_t>(x)] = picture.at<cv::Vec3b>(row, x)[channel];
        const auto middle = values.begin() + picture.cols / 2;
        std::nth_element(values.begin(), middle, values.end());
        median[channel] = *middle;
    }
    return median;
}

/// The share of a row's pixels in [from, to) that differ from a colour by more than `limit`.
double share_of_others(const cv::Mat& picture, int row, cv::Range columns, const cv::Vec3b& colour,
                       int limit) {
    int others = 0;
    for (int x = columns.start; x < columns.end; ++x)
        others += difference(picture.at<cv::Vec3b>(row, x), colour) > limit ? 1 : 0;
    return columns.empty() ? 0 : static_cast<double>(others) / columns.size();
}

/// The band at the top of a picture, without its edge.
SideBand top_band(const cv::Mat& picture) {
    SideBand band{.colour = row_colour(picture, 0)};
    while (band.depth < picture.rows &&
           share_of_others(picture, band.depth, {0, picture.cols}, band.colour, same_colour) <= max_strays)
        ++band.depth;
    return band;
}

/// The edge of the band at the top, measured between the bands at left and right.
double top_edge(const cv::Mat& picture, const SideBand& band, cv::Range columns) {
    double edge = 0;
    for (int row = band.depth; row < std::min(picture.rows, band.depth + edge_rows); ++row)
        edge = std::max(edge, share_of_others(picture, row, columns, band.colour, other_colour));
    return edge;
}

std::size_t index(Side side) {
    return static_cast<std::size_t>(side);
}

bool is_black(const cv::Vec3b& colour) {
    return std::max({colour[0], colour[1], colour[2]}) <= black;
}

cv::Rect within(const Depths& depths, cv::Size size) {
    const int left = depths[index(Side::left)], top = depths[index(Side::top)];
    return {left, top, size.width - left - depths[index(Side::right)],
            size.height - top - depths[index(Side::bottom)]};
}

/// A row that holds the edge itself shows both colours, so it is cut off too.
int cut_depth(int depth) {
    return depth > 0 ? depth + 1 : 0;
}

/// The edges that two bars must have.
struct WantedEdges {
    double each = 0;     // share of the edge of either bar
    double equal = 0;    // the mean of both, for bars equally deep
    double unequal = 0;  // the mean of both, for others
};

constexpr WantedEdges film_edges{.each = 0.2, .equal = 0.35, .unequal = 0.6};
constexpr WantedEdges photo_edges{
    .each = 0.3, .equal = 0.45, .unequal = 0.7};  // one picture is all that is known
constexpr WantedEdges coloured_edges{
    .each = 0.6, .equal = 0.7, .unequal = 0.8};  // else a title on white has bars
constexpr WantedEdges frame_edges{.each = 0.1, .equal = 0.15, .unequal = 0.2};

WantedEdges halved(const WantedEdges& edges) {
    return {.each = edges.each / 2, .equal = edges.equal / 2, .unequal = edges.unequal / 2};
}

/// The bars of two opposite sides. None: {0, 0}. @param edge  the measure of their edges
std::pair<int, int> opposite_bars(const SideBand& a, const SideBand& b, int side, const WantedEdges& wanted,
                                  double SideBand::*edge = &SideBand::edge) {
    const double min = std::max(2.0, std::floor(min_depth * side));  // bands are measured in whole pixels
    if (a.depth < min || b.depth < min || a.depth + b.depth > max_bars * side) return {0, 0};
    const bool are_equal = std::abs(a.depth - b.depth) <= 2 + 0.1 * std::max(a.depth, b.depth);
    const bool is_straight = std::min(a.*edge, b.*edge) >= wanted.each &&
                             (a.*edge + b.*edge) / 2 >= (are_equal ? wanted.equal : wanted.unequal);
    return is_straight ? std::pair(cut_depth(a.depth), cut_depth(b.depth)) : std::pair(0, 0);
}

/// The picture within the bands that are bars.
std::optional<cv::Rect> found_bars(const SideBands& bands, cv::Size size, bool is_photo) {
    const auto& [left, top, right, bottom] = bands;
    const WantedEdges& wanted = is_photo ? photo_edges : film_edges;
    const auto edges_of = [&](const SideBand& a, const SideBand& b) {
        return is_black(a.colour) && is_black(b.colour) ? wanted : coloured_edges;
    };
    auto across = opposite_bars(left, right, size.width, edges_of(left, right));
    auto along = opposite_bars(top, bottom, size.height, edges_of(top, bottom));
    // Two bars of a photo are the frame of a scan, which goes all around it.
    if (is_photo && across.first > 0 && difference(left.colour, top.colour) <= same_colour)
        along = opposite_bars(top, bottom, size.height, frame_edges);
    if (is_photo && along.first > 0 && difference(left.colour, top.colour) <= same_colour)
        across = opposite_bars(left, right, size.width, frame_edges);
    // Bars at two sides alone end in a line from one side to the other, though parts of the picture may be as
    // dark as the bars. A logo on black has a short one.
    if (along.first == 0 && across.first > 0)
        across = opposite_bars(left, right, size.width, halved(edges_of(left, right)), &SideBand::side);
    if (across.first == 0 && along.first > 0)
        along = opposite_bars(top, bottom, size.height, halved(edges_of(top, bottom)), &SideBand::side);
    const cv::Rect active = within({across.first, along.first, across.second, along.second}, size);
    return active.size() == size ? std::nullopt : std::optional(active);
}

/// The depth of one side's band in all pictures but a few.
int common_depth(std::span<const SideBands> pictures, std::size_t side) {
    std::vector<int> depths;
    for (const SideBands& bands : pictures)
        depths.push_back(bands[side].depth);
    const auto kth = static_cast<std::ptrdiff_t>(max_glitches * static_cast<double>(depths.size()));
    std::nth_element(depths.begin(), depths.begin() + kth, depths.end());
    return depths[static_cast<std::size_t>(kth)];
}

/// The edge of a band of that depth: as it is seen in a few pictures at least. 0 where the band changes its
/// colour.
/// @param edge  the measure of it
double lasting_edge(std::span<const SideBands> pictures, std::size_t side, int depth,
                    double SideBand::*edge) {
    const cv::Vec3b& colour = pictures.front()[side].colour;
    std::vector<double> edges;
    for (const SideBands& bands : pictures) {
        const SideBand& band = bands[side];
        const bool is_constant = is_black(band.colour) || difference(band.colour, colour) <= same_colour;
        if (!is_constant && band.depth >= depth) return 0;
        edges.push_back(std::abs(band.depth - depth) <= place_tolerance ? band.*edge : 0);
    }
    const auto kth = static_cast<std::ptrdiff_t>(min_edges * static_cast<double>(edges.size()));
    std::nth_element(edges.begin(), edges.begin() + kth, edges.end(), std::greater<>());
    return edges[static_cast<std::size_t>(kth)];
}

/// Tests if all that `active` leaves out is of one colour.
bool has_room_for(const cv::Rect& active, const Depths& depths, cv::Size size) {
    const Depths cut{active.x, active.y, size.width - active.br().x, size.height - active.br().y};
    for (std::size_t side = 0; side < cut.size(); ++side)
        if (cut[side] > cut_depth(depths[side])) return false;
    return true;
}

}  // namespace

SideBands side_bands(const cv::Mat& bgr) {
    cv::Mat across;
    cv::transpose(bgr, across);
    // The same picture with each side on top.
    std::array<cv::Mat, 4> turned{across, bgr, {}, {}};
    cv::flip(across, turned[index(Side::right)], 0);
    cv::flip(bgr, turned[index(Side::bottom)], 0);
    SideBands bands;
    for (std::size_t side = 0; side < bands.size(); ++side)
        bands[side] = top_band(turned[side]);
    for (std::size_t side = 0; side < bands.size(); ++side) {
        const bool is_upright = side == index(Side::left) || side == index(Side::right);
        const int before = bands[index(is_upright ? Side::top : Side::left)].depth;
        const int after = bands[index(is_upright ? Side::bottom : Side::right)].depth;
        const int length = turned[side].cols;
        const cv::Range columns(std::min(before, length), std::max(std::min(before, length), length - after));
        bands[side].edge = top_edge(turned[side], bands[side], columns);
        bands[side].side = bands[side].edge * columns.size() / length;
    }
    return bands;
}

void ActivePictureFinder::add_picture(const cv::Mat& bgr, std::chrono::nanoseconds time) {
    size_ = bgr.size();
    seen_.push_back({time, side_bands(bgr)});
}

cv::Rect ActivePictureFinder::newest() const {
    if (seen_.empty()) return whole();
    const SideBands& bands = seen_.back().bands;
    if (const auto found = found_bars(bands, size_, true)) return *found;
    Depths depths{};
    for (std::size_t side = 0; side < depths.size(); ++side)
        depths[side] = bands[side].depth;
    return active_picture(Closed{.depths = depths});
}

cv::Rect ActivePictureFinder::close_shot(std::chrono::nanoseconds begin, std::chrono::nanoseconds end) {
    std::vector<SideBands> pictures;
    while (!seen_.empty() && seen_.front().time < end) {
        if (seen_.front().time >= begin) pictures.push_back(seen_.front().bands);
        seen_.pop_front();
    }
    Closed shot{.duration = end - begin};
    if (!pictures.empty()) {
        SideBands bands;
        for (std::size_t side = 0; side < bands.size(); ++side) {
            shot.depths[side] = common_depth(pictures, side);
            bands[side] = {.depth = shot.depths[side],
                           .edge = lasting_edge(pictures, side, shot.depths[side], &SideBand::edge),
                           .side = lasting_edge(pictures, side, shot.depths[side], &SideBand::side),
                           .colour = pictures.front()[side].colour};
        }
        shot.found = found_bars(bands, size_, pictures.size() == 1);
    }
    closed_.push_back(shot);
    return active_picture(shot);
}

std::vector<cv::Rect> ActivePictureFinder::all_shots() const {
    std::vector<cv::Rect> result;
    for (const Closed& shot : closed_)
        result.push_back(active_picture(shot));
    return result;
}

/// The bars that most of the film's time has, among the shots that have some.
std::optional<cv::Rect> ActivePictureFinder::usual_bars() const {
    std::map<std::array<int, 4>, std::chrono::nanoseconds> times;
    for (const Closed& shot : closed_) {
        if (!shot.found) continue;
        times[{shot.found->x, shot.found->y, shot.found->width, shot.found->height}] +=
            std::max(shot.duration, std::chrono::nanoseconds(1));
    }
    if (times.empty()) return std::nullopt;
    const auto usual = std::ranges::max_element(times, {}, [](const auto& entry) { return entry.second; });
    const auto& [x, y, width, height] = usual->first;
    return cv::Rect(x, y, width, height);
}

cv::Rect ActivePictureFinder::active_picture(const Closed& shot) const {
    if (shot.found) return *shot.found;
    const std::optional<cv::Rect> usual = usual_bars();
    return usual && has_room_for(*usual, shot.depths, size_) ? *usual : whole();
}

}  // namespace vitrine::analyzer
