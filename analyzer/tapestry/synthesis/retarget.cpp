// Works from coarse to fine. At half the size the height is carved away, and many rounds mend what that tore;
// then the matches are carried to full size. Simakov et al. scale in many small steps at a sixth of the size
// instead. That merges repetitions, but whole figures too, and never comes as near to the source.

#include "analyzer/tapestry/synthesis/retarget.hpp"

#include "analyzer/tapestry/synthesis/carve_input.hpp"
#include "analyzer/tapestry/synthesis/synthesis.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

namespace vitrine::analyzer {

namespace {

constexpr int tile_width = 500;       // px; source: Video Tapestries 4.2, "about 500"
constexpr int small_overlap = 64;     // px, of such tiles
constexpr int tall_brick = 200;       // px: with taller ones tiles and overlaps grow
constexpr int min_brick_side = 40;    // px at the smallest size; below it too much is merged
constexpr int main_brick_side = 130;  // px: at larger sizes the matches are carried on and hardly change
constexpr int sharp_rounds = 2;       // at such sizes
constexpr double settled = 0.0002;    // share of the energy: a round that lowers it by less is the last

/// The rounds and search radii at the smallest and at full size.
struct Plan {
    int first_rounds;  // at the smallest size
    int last_rounds;   // at larger ones
    int first_radius;  // px of the search
    int last_radius;
};

Plan plan_of(TileQuality quality) {
    if (quality == TileQuality::high)
        return {.first_rounds = 40, .last_rounds = 30, .first_radius = 32, .last_radius = 8};
    return {.first_rounds = 6, .last_rounds = 1, .first_radius = 16, .last_radius = 4};
}

/// Grows a length that suits bricks of up to `tall_brick` px by as much as a brick is taller.
int grown(int px, int brick_height) {
    return px * std::max(tall_brick, brick_height) / tall_brick;
}

/// The scales of a tile, from the smallest to 1.
std::vector<double> scales_of(cv::Size brick) {
    std::vector<double> scales{1};
    const double side = std::min(brick.width, brick.height);
    while (side * scales.back() / 2 >= min_brick_side)
        scales.push_back(scales.back() / 2);
    std::ranges::reverse(scales);
    return scales;
}

KnownPart known_part(const TileNeighbours& neighbours, int tile_px, cv::Size size) {
    KnownPart known;
    if (neighbours.left.empty() && neighbours.right.empty()) return known;
    known.picture = cv::Mat(size, CV_8UC3, cv::Scalar::all(0));
    known.share = cv::Mat(size, CV_32FC1, cv::Scalar::all(0));
    const auto put = [&](const cv::Mat& picture, bool is_left) {
        if (picture.empty()) return;
        const int columns = std::clamp(
            static_cast<int>(std::lround(static_cast<double>(picture.cols) * size.width / tile_px)), 1,
            size.width);
        cv::Mat small;
        cv::resize(picture, small, {columns, size.height}, 0, 0, cv::INTER_AREA);
        small.copyTo(
            known.picture.colRange(is_left ? 0 : size.width - columns, is_left ? columns : size.width));
        for (int i = 0; i < columns; ++i)
            known.share.col(is_left ? i : size.width - 1 - i).setTo(neighbour_share(i, columns));
    };
    put(neighbours.left, true);
    put(neighbours.right, false);
    return known;
}

// Borders of bricks whose pictures do not go together are stitched: they fade into one another.
constexpr int stitch_share = 10;     // of a brick's height: a stitch reaches so far to either side
constexpr int max_stitch = 12;       // px: a neighbour knows all of it
constexpr int border_reach = 4;      // px by which a border may be off its place
constexpr double torn = 2;           // times the steps beside: from there on a border is one
constexpr int stitch_smoothing = 9;  // px down

/// Squared steps from each column to the one before, mean of the channels. CV_32FC1.
cv::Mat steps_across(const cv::Mat& part) {
    cv::Mat values;
    part.convertTo(values, CV_32FC3);
    const cv::Mat difference = values.colRange(1, values.cols) - values.colRange(0, values.cols - 1);
    cv::Mat steps;
    cv::transform(difference.mul(difference), steps, cv::Matx13f(1 / 3.F, 1 / 3.F, 1 / 3.F));
    return steps;
}

/// Softens a border in the middle of a part, where it is one. @param reach  px to either side
void soften(cv::Mat part, int reach) {
    const int middle = part.cols / 2;
    const cv::Mat steps = steps_across(part);
    cv::Mat means;
    cv::reduce(steps, means, 0, cv::REDUCE_AVG);
    const cv::Range near(middle - 1 - border_reach, middle - 1 + border_reach);
    int at = near.start;
    for (int x = near.start; x < near.end; ++x)
        if (means.at<float>(x) > means.at<float>(at)) at = x;
    const double beside =
        (cv::sum(means)[0] - cv::sum(means.colRange(near.start, near.end))[0]) / (means.cols - near.size());
    if (means.at<float>(at) <= torn * beside + 1) return;
    cv::Mat rows = steps.col(at) / (torn * beside + 1) - 1;
    rows = cv::max(0, cv::min(rows, 1));
    cv::blur(rows, rows, {1, stitch_smoothing});
    cv::Mat soft;
    cv::GaussianBlur(part, soft, {2 * reach + 1, 1}, reach / 2.0);
    for (int x = at + 1 - reach; x < at + 1 + reach; ++x) {
        const auto away = static_cast<float>(std::abs(x + 0.5 - (at + 1)) / reach);
        const float share = std::clamp(1.5F * (1 - away), 0.F, 1.F);
        for (int y = 0; y < part.rows; ++y) {
            auto& pixel = part.at<cv::Vec3b>(y, x);
            const float weight = share * rows.at<float>(y);
            pixel = cv::Vec3b((1 - weight) * cv::Vec3f(pixel) + weight * cv::Vec3f(soft.at<cv::Vec3b>(y, x)));
        }
    }
}

/// Softens the borders between bricks of a row. The columns that a neighbour has made stay.
void stitch(cv::Mat& tile, const BrickSection& section, const TileSpan& span,
            const TileNeighbours& neighbours) {
    const Brickwork& brickwork = section.brickwork;
    const int reach = std::clamp(brickwork.brick.height / stitch_share, border_reach + 2, max_stitch);
    const int known = tile_overlap(brickwork.brick.height) / 2;
    const int left = neighbours.left.empty() ? 0 : known;
    const int right = tile.cols - (neighbours.right.empty() ? 0 : known);
    for (int k = 2; k < brickwork.bricks(); ++k) {
        const int x = brickwork.place(k).x - span.from;
        const int beside = std::min({2 * reach, x - left, right - x});
        if (beside < reach + border_reach) continue;
        const int half = tile.rows / 2;
        soften(tile({x - beside, k % 2 * half, 2 * beside, half}), reach);
    }
}

/// Makes the tile, one size after another.
class Tile {
  public:
    Tile(const BrickSection& section, const TileSpan& span, const TileNeighbours& neighbours,
         const RetargetSettings& settings, const RunTasks& run)
        : section_(section),
          span_(span),
          neighbours_(neighbours),
          settings_(settings),
          run_(run),
          plan_(plan_of(settings.quality)),
          scales_(scales_of(section.brickwork.brick)) {}

    cv::Mat made() {
        carve();
        for (std::size_t i = 1; i < scales_.size(); ++i)
            refine(i);
        cv::Mat tile = synthesis_->picture();
        stitch(tile, section_, span_, neighbours_);
        return tile;
    }

  private:
    BrickWindow window(double scale) const { return brick_window(section_, span_, scale, settings_.window); }

    cv::Size target_size(double scale, double height) const {
        return {static_cast<int>(std::lround((span_.to - span_.from) * scale)),
                std::max(patch_side, static_cast<int>(std::lround(height * scale)))};
    }

    std::unique_ptr<Synthesis> synthesis(const BrickWindow& window, const cv::Mat& guess) const {
        return std::make_unique<Synthesis>(
            window, guess, known_part(neighbours_, span_.to - span_.from, guess.size()), run_);
    }

    /// Begins at the smallest size: removes seams in agreement with the neighbours' columns, then mends the
    /// rest.
    void carve() {
        window_ = std::make_unique<BrickWindow>(window(scales_[0]));
        const cv::Size size = target_size(scales_[0], tapestry_height(section_.brickwork));
        CarveInput input = carve_input(*window_, size.width);
        const KnownPart known = known_part(neighbours_, span_.to - span_.from, size);
        if (!known.picture.empty()) give_rows(input, known.picture, known.share.row(0) > 0);
        const KeptRows kept = carved(input, size.height);
        synthesis_ = synthesis(*window_, picture_of(input.picture, kept));
        synthesis_->match_kept(kept);
        improve(plan_.first_rounds, plan_.first_radius);
    }

    void refine(std::size_t size) {
        auto finer_window = std::make_unique<BrickWindow>(window(scales_[size]));
        cv::Mat guess;
        cv::resize(synthesis_->picture(), guess,
                   target_size(scales_[size], tapestry_height(section_.brickwork)), 0, 0, cv::INTER_CUBIC);
        std::unique_ptr<Synthesis> finer = synthesis(*finer_window, guess);
        finer->match_like(*synthesis_);
        synthesis_ = std::move(finer);
        window_ = std::move(finer_window);
        synthesis_->take_votes();
        const cv::Size brick = section_.brickwork.brick;
        const bool is_main = std::min(brick.width, brick.height) * scales_[size] <= main_brick_side;
        improve(is_main ? plan_.last_rounds : sharp_rounds, plan_.last_radius);
    }

    void improve(int rounds, int radius) {
        double before = 0;
        for (int round = 0; round < rounds; ++round) {
            const double energy = synthesis_->step(radius, ++seed_);
            if (round > 0 && energy >= before * (1 - settled)) return;
            before = energy;
        }
    }

    const BrickSection& section_;  // all outlive the tile
    const TileSpan& span_;
    const TileNeighbours& neighbours_;
    const RetargetSettings& settings_;
    const RunTasks& run_;
    Plan plan_;
    std::vector<double> scales_;
    std::unique_ptr<BrickWindow> window_;
    std::unique_ptr<Synthesis> synthesis_;
    std::uint32_t seed_ = 0;
};

}  // namespace

int tile_overlap(int brick_height) {
    return grown(small_overlap, brick_height);
}

std::vector<TileSpan> tile_spans(int strip_width, int brick_height) {
    const int overlap = tile_overlap(brick_height);
    const int step = grown(tile_width, brick_height) - overlap;
    const int tiles =
        std::max(1, static_cast<int>(std::lround(static_cast<double>(strip_width - overlap) / step)));
    std::vector<TileSpan> spans;
    for (std::int64_t i = 0; i < tiles; ++i) {
        const auto border = [&](std::int64_t number) {
            return static_cast<int>(number * (strip_width - overlap) / tiles);
        };
        spans.push_back({.from = border(i), .to = border(i + 1) + overlap});
    }
    return spans;
}

int tapestry_height(const Brickwork& brickwork) {
    return static_cast<int>(std::lround(brickwork.height() * kept_height));
}

cv::Mat retarget_tile(const BrickSection& section, const TileSpan& span, const TileNeighbours& neighbours,
                      const RetargetSettings& settings, const RunTasks& run) {
    return Tile(section, span, neighbours, settings, run).made();
}

}  // namespace vitrine::analyzer
