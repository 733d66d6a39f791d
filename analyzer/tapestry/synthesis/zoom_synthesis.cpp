// Works from the finer level to the coarser one. The picture between the islands keeps its patches as long as
// there is room for them, so that detail stays sharp; growing islands cover it piece by piece.

#include "analyzer/tapestry/synthesis/zoom_synthesis.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/moving_islands.hpp"
#include "analyzer/tapestry/synthesis/retarget.hpp"
#include "analyzer/tapestry/synthesis/zoom_source.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace vitrine::analyzer {

namespace {

constexpr double last_fade = 0.25;  // the last share of the way, in which pixels outside islands fade evenly

/// Adds the columns of the part to the left to the known pixels.
void add_left(const cv::Mat& left, KnownPixels& known) {
    for (int x = 0; x < left.cols; ++x) {
        const float of_left = neighbour_share(x, left.cols);
        for (int y = 0; y < left.rows; ++y) {
            float& share = known.share.at<float>(y, x);
            cv::Vec3b& pixel = known.picture.at<cv::Vec3b>(y, x);
            const float all = 1 - (1 - share) * (1 - of_left);
            if (all <= 0) continue;
            for (int c = 0; c < 3; ++c)
                pixel[c] = cv::saturate_cast<std::uint8_t>(
                    (of_left * left.at<cv::Vec3b>(y, x)[c] + (1 - of_left) * share * pixel[c]) / all);
            share = all;
        }
    }
}

/// A mask of patches: not 0 where some of a patch is unknown.
cv::Mat free_patches(const cv::Mat& share) {
    cv::Mat free;
    cv::Mat counts;
    cv::compare(share, 1, free, cv::CMP_LT);
    cv::boxFilter(free / 255, counts, CV_32S, {patch_side, patch_side}, {0, 0}, false, cv::BORDER_CONSTANT);
    return counts(cv::Rect(0, 0, share.cols - patch_side + 1, share.rows - patch_side + 1)) > 0;
}

/// The picture that the votes and the known pixels give.
cv::Mat counted(const ZoomVotes& votes, const KnownPixels& known) {
    cv::Mat picture = known.picture.clone();
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            const float share = known.share.at<float>(y, x);
            const float* sums = votes.sums(x, y);
            if (share >= 1 || sums[3] <= 0) continue;
            cv::Vec3b& pixel = picture.at<cv::Vec3b>(y, x);
            for (int c = 0; c < 3; ++c)
                pixel[c] =
                    cv::saturate_cast<std::uint8_t>(share * pixel[c] + (1 - share) * sums[c] / sums[3]);
        }
    }
    return picture;
}

/// Makes the pictures of one part, from the finer level to the coarser one.
class Zooming {
  public:
    Zooming(const ZoomPart& part, const ZoomWarps& warps, const ZoomRules& rules, const RunTasks& run)
        : part_(part),
          warps_(warps),
          rules_(rules),
          run_(run),
          islands_(part, warps),
          coarse_(part.coarse),
          fine_(part.fine) {}

    ZoomPictures made(const ZoomPictures& left) {
        ZoomPictures pictures = zoom_ends(part_, rules_.between);
        before_ = pictures.back();
        for (int i = rules_.between; i > 0; --i) {
            const double share = static_cast<double>(i) / (rules_.between + 1);
            before_ = made_at(share, left.empty() ? cv::Mat() : left[as_index(i)]);
            before_share_ = share;
            pictures[as_index(i)] = before_;
        }
        return pictures;
    }

  private:
    KnownPixels known_at(double share, const cv::Mat& left) const {
        KnownPixels known = islands_.at(share);
        const double rest = std::min(share, last_fade) / std::min(before_share_, last_fade);
        known.share = 1 - (1 - known.share) * rest;
        add_left(left, known);
        return known;
    }

    cv::Mat made_at(double share, const cv::Mat& left) {
        const KnownPixels known = known_at(share, left);
        const cv::Mat free = free_patches(known.share);
        const cv::Mat back = warps_.fine.places(part_.columns(share), share, before_share_) -
                             cv::Scalar(part_.columns(before_share_).start, 0);
        const WantedPatches in_coarse{.places = part_.places_in_coarse(warps_.coarse, share),
                                      .is_free = free};
        const WantedPatches in_fine{.places = part_.places_in_fine(warps_.fine, share), .is_free = free};
        coarse_.carry(back, in_coarse);
        fine_.carry(back, in_fine);
        cv::Mat picture = over(bent(before_, back), known.picture, known.share);
        for (int round = 0; round < rules_.rounds; ++round) {
            const PatchImage target(picture);
            ++seed_;
            coarse_.search(target, in_coarse, rules_.radius, seed_, run_);
            fine_.search(target, in_fine, rules_.radius, seed_, run_);
            ZoomVotes votes(picture.cols, picture.rows);
            coarse_.vote(votes, 1 - share, run_);
            fine_.vote(votes, share, run_);
            picture = counted(votes, known);
        }
        return picture;
    }

    const ZoomPart& part_;  // all outlive this
    const ZoomWarps& warps_;
    const ZoomRules& rules_;
    const RunTasks& run_;
    MovingIslands islands_;
    ZoomSource coarse_;
    ZoomSource fine_;
    cv::Mat before_;  // the picture made last, which is shown next
    double before_share_ = 1;
    std::uint32_t seed_ = 0;
};

}  // namespace

ZoomPictures synthesised_zoom(const ZoomPart& part, const ZoomWarps& warps, const ZoomPictures& left,
                              const ZoomRules& rules, const RunTasks& run) {
    return Zooming(part, warps, rules, run).made(left);
}

}  // namespace vitrine::analyzer
