#include "analyzer/saliency/movers.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace vitrine::analyzer {
namespace {

constexpr double moving = 0.5;       // min S_M over a whole mover
constexpr double certain = 0.8;      // min S_M at its strongest place
constexpr double min_share = 0.002;  // share of the picture: a smaller box is a speck
constexpr double max_share = 0.3;    // share of the picture: a larger box is not one thing
constexpr double nearby = 1.0;       // times two boxes' mean side: limit of their centres' distance

std::vector<Box> spots(const SaliencyMap& motion) {
    std::vector<Box> result;
    if (motion.empty()) return result;
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centres;
    const cv::Mat mask = motion >= moving;
    const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8, CV_32S);
    for (int i = 1; i < count; ++i) {
        const cv::Rect r(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                         stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
        const double part = r.area() / static_cast<double>(motion.total());
        if (part < min_share || part > max_share) continue;
        double strongest = 0;
        cv::minMaxLoc(motion(r), nullptr, &strongest, nullptr, nullptr, labels(r) == i);
        if (strongest < certain) continue;
        result.push_back({{static_cast<double>(r.x), static_cast<double>(r.y)},
                          {static_cast<double>(r.x + r.width), static_cast<double>(r.y + r.height)}});
    }
    return result;
}

bool has_near(const std::vector<Box>& boxes, const Box& box) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& other) {
        const double side = (box.width() + box.height() + other.width() + other.height()) / 4;
        return length(box.centre() - other.centre()) <= nearby * side;
    });
}

}  // namespace

std::vector<Box> movers(const std::vector<Sample>& samples, std::chrono::nanoseconds begin, Vec2 drift) {
    std::vector<std::vector<Box>> found;
    found.reserve(samples.size());
    for (const Sample& sample : samples)
        found.push_back(spots(sample.motion));
    std::vector<Box> result;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Vec2 moved_by = drift * -std::chrono::duration<double>(samples[i].time - begin).count();
        for (const Box& box : found[i]) {
            const bool is_seen_before = i > 0 && has_near(found[i - 1], box);
            const bool is_seen_after = i + 1 < found.size() && has_near(found[i + 1], box);
            if (!is_seen_before && !is_seen_after) continue;
            result.push_back({box.min + moved_by, box.max + moved_by});
        }
    }
    return result;
}

}  // namespace vitrine::analyzer
