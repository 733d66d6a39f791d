#include "analyzer/tapestry/synthesis/carve_input.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <limits>

namespace vitrine::analyzer {

namespace {

constexpr float step_loss = 3;        // times the mean squared step down around a lost pixel, in a patch
constexpr float subject_loss = 2000;  // squared grey levels for each pixel of a face or region
constexpr float break_cost = 150;  // squared grey levels for each place where rows are gone in a known column
constexpr int columns_beside = 2;  // known columns to either side that help to find the rows of one

/// The brick of a pixel, by any patch that the pixel lies in.
std::int16_t brick_at(const BrickWindow& window, int x, int y) {
    const int columns = window.picture.patch_columns();
    for (int top = y; top > y - patch_side; --top) {
        for (int left = x; left > x - patch_side; --left) {
            if (left < 0 || top < 0 || left >= columns || top >= window.picture.patch_rows()) continue;
            const std::int16_t owner = window.rules.owners[as_index(top * columns + left)];
            if (owner != PatchRules::no_brick) return owner;
        }
    }
    return PatchRules::no_brick;
}

bool is_subject(const BrickWindow& window, int x, int y) {
    const int left = std::clamp(x - patch_side / 2, 0, window.picture.patch_columns() - 1);
    const int top = std::clamp(y - patch_side / 2, 0, window.picture.patch_rows() - 1);
    return window.rules.weights[as_index(top * window.picture.patch_columns() + left)] > 1;
}

float squared(const cv::Vec3b& a, const cv::Vec3b& b) {
    const cv::Vec3f difference = cv::Vec3f(a) - cv::Vec3f(b);
    return difference.dot(difference);
}

cv::Mat steps_down(const CarveInput& input) {
    cv::Mat steps(input.picture.size(), CV_32FC1, cv::Scalar(0));
    for (int y = 0; y + 1 < steps.rows; ++y)
        for (int x = 0; x < steps.cols; ++x)
            if (input.bricks.at<std::int16_t>(y, x) == input.bricks.at<std::int16_t>(y + 1, x))
                steps.at<float>(y, x) =
                    squared(input.picture.at<cv::Vec3b>(y, x), input.picture.at<cv::Vec3b>(y + 1, x));
    return steps;
}

/// Squared differences between a known column and the picture's: at (y, k) of its pixel y and pixel y + k.
cv::Mat column_differences(const cv::Mat& known, const cv::Mat& column) {
    cv::Mat differences(known.rows, column.rows - known.rows + 1, CV_32FC1);
    for (int y = 0; y < differences.rows; ++y)
        for (int k = 0; k < differences.cols; ++k)
            differences.at<float>(y, k) = squared(known.at<cv::Vec3b>(y), column.at<cv::Vec3b>(y + k));
    return differences;
}

/// Says how many rows are gone above each row of a known column: the cheapest choice that never falls.
std::vector<int> gone_above(const cv::Mat& differences) {
    cv::Mat sums = differences.clone();
    cv::Mat from(differences.size(), CV_32SC1, cv::Scalar(0));
    for (int y = 1; y < sums.rows; ++y) {
        float least = std::numeric_limits<float>::max();
        int least_at = 0;
        for (int k = 0; k < sums.cols; ++k) {
            const float same = sums.at<float>(y - 1, k);
            const bool breaks = least < same;
            sums.at<float>(y, k) += breaks ? least : same;
            from.at<int>(y, k) = breaks ? least_at : k;
            if (same + break_cost >= least) continue;
            least = same + break_cost;
            least_at = k;
        }
    }
    std::vector<int> gone(as_index(sums.rows));
    const auto* last = sums.ptr<float>(sums.rows - 1);
    auto k = static_cast<int>(std::min_element(last, last + sums.cols) - last);
    for (int y = sums.rows - 1; y >= 0; --y) {
        gone[as_index(y)] = k;
        k = from.at<int>(y, k);
    }
    return gone;
}

}  // namespace

CarveInput carve_input(const BrickWindow& window, int width) {
    const int height = window.picture.height();
    const int from = window.rules.target_x;
    CarveInput input{.picture = cv::Mat(height, width, CV_8UC3),
                     .bricks = cv::Mat(height, width, CV_16SC1),
                     .loss = cv::Mat(height, width, CV_32FC1),
                     .given = {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int place = std::min(from + x, window.picture.width() - 1);
            const std::uint8_t* pixel = window.picture.at(place, y);
            input.picture.at<cv::Vec3b>(y, x) = {pixel[0], pixel[1], pixel[2]};
            input.bricks.at<std::int16_t>(y, x) = brick_at(window, place, y);
        }
    }
    cv::boxFilter(steps_down(input), input.loss, CV_32F, {1, patch_side});
    input.loss *= step_loss;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (is_subject(window, from + x, y)) input.loss.at<float>(y, x) += subject_loss;
    return input;
}

void give_rows(CarveInput& input, const cv::Mat& known, const cv::Mat& columns) {
    const auto is_known = [&](int x) {
        return x >= 0 && x < columns.cols && columns.at<std::uint8_t>(x) != 0;
    };
    input.given = cv::Mat(input.picture.size(), CV_8UC1, cv::Scalar(CarveInput::open));
    std::vector<cv::Mat> differences(as_index(known.cols));
    for (int x = 0; x < known.cols; ++x)
        if (is_known(x))
            differences[as_index(x)] = column_differences(known.col(x).clone(), input.picture.col(x).clone());
    for (int x = 0; x < known.cols; ++x) {
        if (!is_known(x)) continue;
        cv::Mat around = differences[as_index(x)].clone();
        for (int beside = 1; beside <= columns_beside; ++beside)
            for (const int column : {x - beside, x + beside})
                if (is_known(column)) around += differences[as_index(column)];
        const std::vector<int> gone = gone_above(around);
        input.given.col(x).setTo(cv::Scalar(CarveInput::goes));
        for (int y = 0; y < known.rows; ++y)
            input.given.at<std::uint8_t>(y + gone[as_index(y)], x) = CarveInput::stays;
    }
}

}  // namespace vitrine::analyzer
