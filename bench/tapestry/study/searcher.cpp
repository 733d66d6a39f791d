#include "bench/tapestry/study/searcher.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <span>

namespace vitrine::study {

namespace {

using std::chrono::nanoseconds;

constexpr float max_difference = 60;  // grey levels; a part that is not there counts as this
constexpr int columns = 5;            // parts of the sought frame
constexpr int rows = 3;
constexpr double outstanding = 0.8;  // of the median difference in view

struct Place {
    cv::Point at;
    float difference = 0;
};

class Search {
  public:
    Search(const SearchedInterface& interface, const SoughtScene& scene)
        : interface_(interface), scene_(scene) {
        for (const SearchedLevel& level : interface.levels) {
            places_.push_back(places_on(level));
            seen_.emplace_back(std::max(level.picture.cols, 1), false);
        }
    }

    int run() {
        while (steps_ < max_steps && !is_found_)
            take_step();
        return std::min(steps_, max_steps);
    }

  private:
    int screen_width() const { return interface_.screen_width; }

    const SearchedLevel& level() const { return interface_.levels[level_]; }

    /// The most alike place of each column of pixels.
    std::vector<Place> places_on(const SearchedLevel& level) const {
        if (level.picture.empty()) return {};
        cv::Mat frame;
        cv::resize(scene_.frame, frame, level.frame, 0, 0, cv::INTER_AREA);
        const cv::Mat found = differences(level.picture, frame);
        std::vector<Place> places;
        for (int x = 0; x < found.cols; ++x) {
            double value = 0;
            cv::Point at;
            cv::minMaxLoc(found.col(x), &value, nullptr, &at, nullptr);
            places.push_back({.at = {x, at.y}, .difference = static_cast<float>(value)});
        }
        return places;
    }

    void take_step() {
        look();
        if (const std::optional<Place> place = best(places_in_view()); place && stands_out(*place))
            return click(level().moment_at(place->at));
        if (const std::optional<int> x = next_unseen()) return drag_to(*x);
        if (level_ + 1 < interface_.levels.size()) return zoom_in();
        click(middle_of_longest_gap());
    }

    void look() {
        std::vector<bool>& seen = seen_[level_];
        const int last = std::min(left_ + screen_width(), static_cast<int>(seen.size()));
        std::fill(seen.begin() + left_, seen.begin() + last, true);
    }

    /// A place near which a click has shown another shot, or that leads to the same moment, is not tried
    /// again.
    bool is_tried(cv::Point at) const {
        return std::ranges::any_of(clicked_, [&](nanoseconds moment) {
            return 2 * std::abs(level().x_at(moment) - at.x) < level().frame.width ||
                   level().moment_at(at) == moment;
        });
    }

    std::span<const Place> places_in_view() const {
        const std::span<const Place> all = places_[level_];
        const auto left = static_cast<std::size_t>(left_);
        return all.subspan(left, std::min(all.size() - left, static_cast<std::size_t>(screen_width())));
    }

    std::optional<Place> best(std::span<const Place> places) const {
        std::optional<Place> best;
        for (const Place& place : places)
            if ((!best || place.difference < best->difference) && !is_tried(place.at)) best = place;
        return best;
    }

    bool stands_out(const Place& place) const {
        std::vector<float> values;
        for (const Place& other : places_in_view())
            values.push_back(other.difference);
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, middle);
        return place.difference <= outstanding * *middle;
    }

    /// The place to look at next on this level, px; nothing where all of it has been seen.
    std::optional<int> next_unseen() const {
        const std::vector<bool>& seen = seen_[level_];
        if (level_ == 0) {
            const auto first = std::ranges::find(seen, false);
            if (first == seen.end() || places_[0].empty()) return std::nullopt;
            return static_cast<int>(first - seen.begin()) + screen_width() / 2;
        }
        const SearchedLevel& coarser = interface_.levels[level_ - 1];
        std::optional<Place> next;
        for (const Place& place : places_[level_ - 1]) {
            if (next && place.difference >= next->difference) continue;
            const int here = level().x_at(coarser.moment_at(place.at));
            if (!seen[static_cast<std::size_t>(here)]) next = Place{{here, 0}, place.difference};
        }
        if (!next) return std::nullopt;
        return next->at.x;
    }

    /// Brings a place of this level to the middle of the screen, or as near to it as the level's ends allow.
    void drag_to(int x) {
        const int width = screen_width();
        const int last = std::max(level().picture.cols - width, 0);
        const int left = std::clamp(x - width / 2, 0, last);
        const int screens = (std::abs(left - left_) + width - 1) / width;
        steps_ += std::max(screens, 1);
        left_ = left;
    }

    void zoom_in() {
        const std::optional<Place> place = best(places_[level_]);
        const cv::Point at = place ? place->at : cv::Point(left_ + screen_width() / 2, 0);
        if (at.x < left_ || at.x >= left_ + screen_width()) drag_to(at.x);
        const nanoseconds moment = level().moment_at(at);
        const int within = at.x - left_;
        ++level_;
        ++steps_;
        const int last = std::max(level().picture.cols - screen_width(), 0);
        left_ = std::clamp(level().x_at(moment) - within, 0, last);
    }

    void click(nanoseconds moment) {
        ++steps_;
        clicked_.push_back(moment);
        is_found_ = moment >= scene_.shot_begin && moment < scene_.shot_end;
    }

    nanoseconds middle_of_longest_gap() const {
        std::vector<nanoseconds> ends = clicked_;
        ends.insert(ends.end(), {nanoseconds(0), interface_.duration});
        std::ranges::sort(ends);
        std::size_t longest = 1;
        for (std::size_t i = 2; i < ends.size(); ++i)
            if (ends[i] - ends[i - 1] > ends[longest] - ends[longest - 1]) longest = i;
        return ends[longest - 1] + (ends[longest] - ends[longest - 1]) / 2;
    }

    const SearchedInterface& interface_;  // both outlive this
    const SoughtScene& scene_;
    std::vector<std::vector<Place>> places_;  // of a level, one a column of pixels
    std::vector<std::vector<bool>> seen_;     // of a level, px
    std::vector<nanoseconds> clicked_;
    std::size_t level_ = 0;
    int left_ = 0;  // px of the level at the screen's left edge
    int steps_ = 0;
    bool is_found_ = false;
};

/// The difference of one part of the frame by the place of its middle, the least within half its size.
cv::Mat part_differences(const cv::Mat& padded, const cv::Mat& part) {
    cv::Mat squares;
    cv::matchTemplate(padded, part, squares, cv::TM_SQDIFF);
    cv::Mat found = cv::max(squares, 0.0) / (3.0 * static_cast<double>(part.total()));
    cv::sqrt(found, found);
    found = cv::min(found, max_difference);
    const cv::Mat reach(part.rows / 2 * 2 + 1, part.cols / 2 * 2 + 1, CV_8U, cv::Scalar(1));
    cv::erode(found, found, reach);
    return found;
}

}  // namespace

int count_steps(const SearchedInterface& interface, const SoughtScene& scene) {
    return Search(interface, scene).run();
}

cv::Mat differences(const cv::Mat& picture, const cv::Mat& frame) {
    const int across = frame.cols;
    const int down = frame.rows;
    cv::Mat padded;
    cv::copyMakeBorder(picture, padded, down, down, across, across, cv::BORDER_CONSTANT,
                       cv::Scalar::all(128));
    cv::Mat sum(picture.size(), CV_32F, cv::Scalar(0));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const cv::Point begin(across * column / columns, down * row / rows);
            const cv::Point end(across * (column + 1) / columns, down * (row + 1) / rows);
            const cv::Mat found = part_differences(padded, frame(cv::Rect(begin, end)));
            // The frame's middle at (0, 0) of the picture has its corner half a frame before it.
            const cv::Point corner(across - across / 2 + begin.x, down - down / 2 + begin.y);
            sum += found(cv::Rect(corner, picture.size()));
        }
    return sum / (rows * columns);
}

}  // namespace vitrine::study
