#include "analyzer/tapestry/weave/first_view.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/frame_fitness.hpp"
#include "analyzer/tapestry/synthesis/retarget.hpp"
#include "analyzer/tapestry/weave/frame_sheets.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int max_feather = 8;     // px of a soft seam on both sides of a brick's edge
constexpr int margin_share = 8;    // of a brick's width, from which the half brick beside it is drawn
constexpr double margin_blur = 8;  // a brick's heights for one sigma

/// Bricks that overlap at their seams, with their shares.
class SoftBricks {
  public:
    explicit SoftBricks(const Brickwork& brickwork)
        : brick_(brickwork.brick),
          strip_(brickwork.width(), tapestry_height(brickwork)),
          feather_(std::min(max_feather, brick_.height / (2 * margin_share))),
          sum_(strip_, CV_32FC3, cv::Scalar::all(0)),
          shares_(strip_, CV_32FC1, cv::Scalar(1e-6)) {}

    /// @param number  of the brick; -1 and bricks() lie half outside
    void lay(const cv::Mat& picture, double middle, int number) {
        const int row = number & 1;
        const cv::Rect place(number * brick_.width / 2 - feather_, row * strip_.height / 2 - feather_,
                             brick_.width + 2 * feather_, strip_.height / 2 + 2 * feather_);
        const cv::Rect seen = place & cv::Rect({}, strip_);
        if (seen.empty()) return;
        const cv::Rect part = seen - place.tl();
        const cv::Mat share = shares_of(place.size())(part);
        cv::Mat weighted;
        cv::merge(std::vector<cv::Mat>(3, share), weighted);
        cv::multiply(cut(picture, middle, place.size())(part), weighted, weighted, 1, CV_32F);
        sum_(seen) += weighted;
        shares_(seen) += share;
    }

    cv::Mat strip() const {
        cv::Mat shares;
        cv::merge(std::vector<cv::Mat>(3, shares_), shares);
        cv::Mat strip;
        cv::divide(sum_, shares, strip, 1, CV_8U);
        return strip;
    }

  private:
    /// The part of a picture that a place shows, about its middle of interest. Beyond the picture's top and
    /// bottom there is as much as a seam takes.
    /// @param middle  px of the picture from its top
    cv::Mat cut(const cv::Mat& picture, double middle, cv::Size size) const {
        const double scale = static_cast<double>(size.width) / picture.cols;
        const int rows = std::max(size.height, static_cast<int>(std::lround(picture.rows * scale)));
        cv::Mat large;
        cv::resize(picture, large, {size.width, rows}, 0, 0, cv::INTER_LINEAR);
        cv::copyMakeBorder(large, large, feather_, feather_, 0, 0, cv::BORDER_REPLICATE);
        const int top = static_cast<int>(std::lround(middle * scale + feather_ - size.height / 2.0));
        return large(cv::Rect({0, std::clamp(top, 0, large.rows - size.height)}, size));
    }

    /// A brick's share at each px: less and less towards its edges.
    cv::Mat shares_of(cv::Size size) const {
        cv::Mat shares(size, CV_32FC1);
        const auto ramp = [&](int at, int length) {
            const int inside = std::min(at, length - 1 - at);
            return std::min(1.F, (static_cast<float>(inside) + 0.5F) / static_cast<float>(2 * feather_));
        };
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                shares.at<float>(y, x) = feather_ == 0 ? 1.F : ramp(x, size.width) * ramp(y, size.height);
        return shares;
    }

    cv::Size brick_;
    cv::Size strip_;  // px
    int feather_;     // px
    cv::Mat sum_;     // CV_32FC3: of colours by shares
    cv::Mat shares_;  // CV_32FC1
};

/// A picture for the half brick beside the first or last one of a row: its margin, mirrored, drawn out and
/// blurred.
cv::Mat picture_beside(const cv::Mat& picture, bool is_left) {
    const int columns = std::max(1, picture.cols / margin_share);
    cv::Mat margin;
    cv::flip(is_left ? picture.colRange(0, columns) : picture.colRange(picture.cols - columns, picture.cols),
             margin, 1);
    cv::resize(margin, margin, picture.size(), 0, 0, cv::INTER_LINEAR);
    cv::GaussianBlur(margin, margin, {}, picture.rows / margin_blur);
    return margin;
}

/// The middle of what matters in a picture, px from its top.
double middle_of(const Keyframe& keyframe) {
    if (keyframe.region.empty()) return keyframe.picture.rows / 2.0;
    const cv::Rect box = cv::boundingRect(keyframe.region);
    return box.y + box.height / 2.0;
}

void write_tiles(const fs::path& directory, const Tapestry& tapestry, const cv::Mat& strip) {
    fs::create_directories((directory / tapestry.tile_name(0, 0)).parent_path());
    for (int tile = 0; tile < tapestry.tiles(0); ++tile) {
        const int from = tile * tapestry.tile_width;
        const int to = std::min(from + tapestry.tile_width, strip.cols);
        write_jpeg(directory / tapestry.tile_name(0, tile), strip.colRange(from, to).clone());
    }
}

}  // namespace

Keyframes first_keyframes(const Candidates& candidates, int count, const KeyframeChoice& chosen) {
    const std::vector<FrameSignature>& frames = candidates.signatures();
    std::vector<FilmPart> shots;
    for (const Shot& shot : candidates.film().shots)
        shots.push_back({shot.begin, shot.end});
    Keyframes keyframes = keyframes_at(frames, chosen.keyframes);
    if (chosen.is_only) return keyframes;
    const std::vector<bool> fit = fit_frames(frames, shots);
    std::vector<int> standing;  // the frames that may be shown
    for (int frame = 0; frame < static_cast<int>(frames.size()); ++frame)
        if (fit[as_index(frame)] && !is_struck(chosen, frames[as_index(frame)].time))
            standing.push_back(frame);
    for (const int number : uniform_keyframes(static_cast<int>(standing.size()), count))
        keyframes.push_back(standing[as_index(number)]);
    std::ranges::sort(keyframes);
    keyframes.erase(std::unique(keyframes.begin(), keyframes.end()), keyframes.end());
    if (keyframes.empty()) keyframes.push_back(0);
    return keyframes;
}

cv::Mat plain_strip(const Brickwork& brickwork, const std::function<Keyframe(int)>& keyframe) {
    if (brickwork.keyframes == 1) {
        cv::Mat strip;
        cv::resize(keyframe(0).picture, strip, {brickwork.width(), tapestry_height(brickwork)}, 0, 0,
                   cv::INTER_CUBIC);
        return strip;
    }
    SoftBricks bricks(brickwork);
    for (int number = 0; number < brickwork.bricks(); ++number) {
        const Keyframe one = keyframe(number);
        const double middle = middle_of(one);
        bricks.lay(one.picture, middle, number);
        if (number == 1) bricks.lay(picture_beside(one.picture, true), middle, -1);
        if (number == brickwork.bricks() - 2)
            bricks.lay(picture_beside(one.picture, false), middle, brickwork.bricks());
    }
    return bricks.strip();
}

void write_first_view(const fs::path& directory, const Tapestry& head, const std::string& folder,
                      const Film& film, const KeyframeChoice& chosen) {
    const Candidates& candidates = *film.candidates;
    const Keyframes keyframes = first_keyframes(candidates, KeyframeSettings{}.first, chosen);
    const Brickwork brickwork = brickwork_of(keyframes, candidates.brick());
    const cv::Mat strip = plain_strip(
        brickwork, [&](int k) { return candidates.keyframe(keyframes[as_index(k)], FaceSearch::left_out); });
    Tapestry tapestry = head;
    tapestry.duration = film.duration;
    tapestry.folder = folder;
    tapestry.height = strip.rows;
    tapestry.tile_width = tile_file_width;
    tapestry.brick_width = candidates.brick().width;
    tapestry.levels = {level_of(keyframes, candidates)};
    write_tiles(directory, tapestry, strip);
    write_tapestry(directory, tapestry);
    tapestry.kept = write_frame_sheets(directory, tapestry, candidates);
    tapestry.digits = write_digits(directory, tapestry);
    write_tapestry(directory, tapestry);
}

}  // namespace vitrine::analyzer
