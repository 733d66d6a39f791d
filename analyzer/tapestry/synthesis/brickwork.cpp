#include "analyzer/tapestry/synthesis/brickwork.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

cv::Rect scaled(const cv::Rect& rect, int from, double scale) {
    const auto at = [&](int px) { return static_cast<int>(std::lround(px * scale)); };
    const cv::Point corner(at(rect.x - from), at(rect.y));
    const cv::Point other(at(rect.x - from + rect.width), at(rect.y + rect.height));
    return {corner, other};
}

void draw(const cv::Mat& picture, const cv::Rect& place, cv::Mat& onto) {
    const cv::Rect seen = place & cv::Rect({}, onto.size());
    if (seen.empty()) return;
    cv::Mat small = picture;
    if (picture.size() != place.size()) cv::resize(picture, small, place.size(), 0, 0, cv::INTER_AREA);
    small(seen - place.tl()).copyTo(onto(seen));
}

constexpr int margin_share = 8;     // of a brick's width: so much is drawn out, whatever it shows
constexpr double margin_blur = 24;  // a brick's heights for one sigma, for each time that it is drawn out
constexpr double min_sigma = 0.3;   // px

/// The columns beside all that matters in a picture, at one of its sides. A region that is not known reaches
/// to the side.
int columns_beside(const Keyframe& keyframe, bool is_left) {
    if (keyframe.region.empty()) return 0;
    cv::Rect matters = cv::boundingRect(keyframe.region);
    for (const cv::Rect& face : keyframe.faces)
        matters |= face;
    return is_left ? matters.x : keyframe.picture.cols - matters.x - matters.width;
}

/// Fills the half brick beside the first or last one of a row with its margin, mirrored. A margin narrower
/// than that is drawn out, and blurred the more. What matters in the picture is not shown again, as it would
/// be cut in halves.
/// @param place  of a brick that lies half outside of the strip
void draw_beside(const Keyframe& keyframe, bool is_left, const cv::Rect& place, cv::Mat& onto) {
    const cv::Mat& picture = keyframe.picture;
    const int least = std::max(1, picture.cols / margin_share);
    const int columns =
        std::clamp(columns_beside(keyframe, is_left), least, std::max(least, picture.cols / 2));
    cv::Mat margin;
    cv::flip(is_left ? picture.colRange(0, columns) : picture.colRange(picture.cols - columns, picture.cols),
             margin, 1);
    cv::resize(margin, margin, {std::max(1, place.width / 2), place.height}, 0, 0, cv::INTER_LINEAR);
    const double drawn_out = picture.cols / 2.0 / columns;
    const double sigma = (drawn_out - 1) * place.height / margin_blur;
    if (sigma > min_sigma) cv::GaussianBlur(margin, margin, {}, sigma);
    const cv::Point half(is_left ? place.width - margin.cols : 0, 0);
    draw(margin, {place.tl() + half, margin.size()}, onto);
}

/// The places of the patches that lie wholly inside a rectangle.
cv::Rect patches_in(const cv::Rect& rect, cv::Size window) {
    const cv::Rect seen = rect & cv::Rect({}, window);
    return {seen.x, seen.y, std::max(0, seen.width - patch_side + 1),
            std::max(0, seen.height - patch_side + 1)};
}

void own(PatchRules& rules, const cv::Rect& patches, int columns, int number) {
    for (int y = patches.y; y < patches.y + patches.height; ++y) {
        const auto row = rules.owners.begin() + static_cast<std::ptrdiff_t>(y) * columns + patches.x;
        std::fill(row, row + patches.width, static_cast<std::int16_t>(number));
    }
}

/// The patches to demand.
struct PatchSpan {
    int columns = 0;  // columns of patches in the window
    cv::Range tile;   // columns of the window
    int weight = 1;
};

/// Demands the patches whose middle lies in the tile.
void demand(PatchRules& rules, const cv::Rect& patches, const PatchSpan& span) {
    const cv::Range tile = span.tile;
    for (int y = patches.y; y < patches.y + patches.height; ++y) {
        for (int x = patches.x; x < patches.x + patches.width; ++x) {
            const bool is_demanded = x + patch_side / 2 >= tile.start && x + patch_side / 2 < tile.end;
            const std::size_t place = static_cast<std::size_t>(y) * static_cast<std::size_t>(span.columns) +
                                      static_cast<std::size_t>(x);
            if (is_demanded) rules.weights[place] = static_cast<std::uint8_t>(span.weight);
        }
    }
}

/// Demands the patches of a brick whose middle lies in the region.
/// @param region  px of the window
void demand_region(PatchRules& rules, const std::vector<cv::Point>& region, const cv::Rect& patches,
                   const PatchSpan& span) {
    if (region.size() < 3 || patches.empty()) return;
    cv::Mat inside(patches.size(), CV_8UC1, cv::Scalar(0));
    const cv::Point corner = patches.tl() + cv::Point(patch_side / 2, patch_side / 2);
    std::vector<cv::Point> corners;
    corners.reserve(region.size());
    for (const cv::Point& point : region)
        corners.push_back(point - corner);
    cv::fillConvexPoly(inside, corners, cv::Scalar(1));
    for (int y = 0; y < patches.height; ++y) {
        for (int x = 0; x < patches.width; ++x) {
            if (inside.at<std::uint8_t>(y, x) == 0) continue;
            demand(rules, {patches.x + x, patches.y + y, 1, 1}, span);
        }
    }
}

/// The patches of a brick that touch a face.
cv::Rect patches_at(const cv::Rect& face, const cv::Rect& patches) {
    const cv::Rect touching(face.x - patch_side + 1, face.y - patch_side + 1, face.width + patch_side - 1,
                            face.height + patch_side - 1);
    return touching & patches;
}

}  // namespace

int Brickwork::first_at(int x) const {
    return std::clamp(2 * x / brick.width - 1, 0, bricks() - 1);
}

int Brickwork::last_at(int x) const {
    return std::clamp((2 * x + brick.width - 1) / brick.width, 1, bricks());
}

cv::Range window_of(const Brickwork& brickwork, const TileSpan& tile) {
    const int margin = brickwork.brick.width / 2;
    return {std::max(0, tile.from - margin), std::min(brickwork.width(), tile.to + margin)};
}

BrickWindow brick_window(const BrickSection& section, const TileSpan& tile, double scale,
                         const WindowSettings& settings) {
    const Brickwork& brickwork = section.brickwork;
    const cv::Range range = window_of(brickwork, tile);
    const cv::Rect whole = scaled({range.start, 0, range.size(), brickwork.height()}, range.start, scale);
    const cv::Rect small_tile = scaled({tile.from, 0, tile.to - tile.from, 1}, range.start, scale);
    const cv::Range demanded(small_tile.x, small_tile.x + small_tile.width);
    cv::Mat canvas(whole.size(), CV_8UC3, cv::Scalar::all(0));
    const int columns = whole.width - patch_side + 1;
    const auto patches = as_index(columns) * as_index(whole.height - patch_side + 1);
    const double half = brickwork.brick.width * scale / 2;
    PatchRules rules{.owners = std::vector<std::int16_t>(patches, PatchRules::no_brick),
                     .weights = std::vector<std::uint8_t>(patches, 0),
                     .centres = {},
                     .target_x = demanded.start,
                     .reach = half,
                     .time_cost = settings.time_cost * patch_values / (half * half)};
    const auto place = [&](int number) { return scaled(brickwork.place(number), range.start, scale); };
    for (std::size_t i = 0; i < section.bricks.size(); ++i) {
        const int number = section.first + static_cast<int>(i);
        const Keyframe& keyframe = section.bricks[i];
        const cv::Rect at = place(number);
        if (number == 1) draw_beside(keyframe, true, place(-1), canvas);
        if (number == brickwork.bricks() - 2) draw_beside(keyframe, false, place(number + 2), canvas);
        draw(keyframe.picture, at, canvas);
        rules.centres.push_back(at.x + at.width / 2);
        const cv::Rect inside = patches_in(at, whole.size());
        own(rules, inside, columns, static_cast<int>(i));
        demand(rules, inside, {columns, demanded, 1});
        std::vector<cv::Point> region;
        for (const cv::Point& corner : keyframe.region)
            region.push_back(at.tl() + scaled({corner, cv::Size(0, 0)}, 0, scale).tl());
        demand_region(rules, region, inside, {columns, demanded, settings.region_weight});
        for (const cv::Rect& face : keyframe.faces) {
            const cv::Rect small = scaled(face, 0, scale);
            demand(rules, patches_at(small + at.tl(), inside), {columns, demanded, settings.face_weight});
        }
    }
    return {.picture = PatchImage(canvas), .rules = std::move(rules)};
}

}  // namespace vitrine::analyzer
