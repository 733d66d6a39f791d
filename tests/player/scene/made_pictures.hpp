#pragma once

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace vitrine::player {

/// Makes pictures and changes them as photographers and phones do. The same seed gives the same pictures.
class MadePictures {
  public:
    explicit MadePictures(unsigned seed) : engine_(seed) {}

    /// In [low, high).
    double number(double low, double high) {
        constexpr unsigned steps = 1'000'000;
        return low + (high - low) * static_cast<double>(engine_() % steps) / steps;
    }

    int whole(int below) { return static_cast<int>(engine_() % static_cast<unsigned>(below)); }

    /// A scene: a ground with a gradient, and shapes.
    cv::Mat scene() {
        cv::Mat picture(427, 640, CV_8UC3);
        const cv::Scalar first = colour();
        const cv::Scalar second = colour();
        const double angle = number(0, 6.28);
        for (int y = 0; y < picture.rows; ++y)
            for (int x = 0; x < picture.cols; ++x) {
                const double share = std::clamp(0.5 + (x / 640.0 - 0.5) * std::cos(angle) +
                                                    (y / 427.0 - 0.5) * std::sin(angle),
                                                0.0, 1.0);
                for (int c = 0; c < 3; ++c)
                    picture.at<cv::Vec3b>(y, x)[c] =
                        cv::saturate_cast<std::uint8_t>(first[c] * (1 - share) + second[c] * share);
            }
        const int shapes = 3 + whole(12);
        for (int i = 0; i < shapes; ++i) {
            const cv::Point at(whole(picture.cols), whole(picture.rows));
            const cv::Size size(20 + whole(140), 20 + whole(120));
            if (whole(2) == 0)
                cv::rectangle(picture, {at, size}, colour(), cv::FILLED);
            else
                cv::ellipse(picture, at, size, number(0, 180), 0, 360, colour(), cv::FILLED, cv::LINE_AA);
        }
        return picture;
    }

    /// The same take with another exposure.
    cv::Mat exposed(const cv::Mat& picture) {
        return exposed(picture, number(0.65, 1.45), number(0.8, 1.25));
    }

    /// A part of the picture. @param least  share of its sides that stays
    cv::Mat cropped(const cv::Mat& picture, double least) {
        const double share = number(least, 0.99);
        const cv::Size size(static_cast<int>(picture.cols * share), static_cast<int>(picture.rows * share));
        return picture({{whole(picture.cols - size.width), whole(picture.rows - size.height)}, size}).clone();
    }

    /// The next frame: the hand has moved a little, and so has something in the picture.
    cv::Mat next_frame(const cv::Mat& picture) { return with_moved_part(cropped(picture, 0.96), 0.22); }

    /// The same room from the same place on another day: other light, and several things have moved.
    cv::Mat another_day(const cv::Mat& picture) {
        cv::Mat other = cropped(picture, 0.96);
        for (int i = 0; i < 3; ++i)
            other = with_moved_part(other, 0.18);
        return exposed(other, number(0.75, 1.25), number(0.85, 1.15));
    }

  private:
    cv::Scalar colour() {
        const int blue = whole(256), green = whole(256), red = whole(256);
        return {static_cast<double>(blue), static_cast<double>(green), static_cast<double>(red)};
    }

    static cv::Mat exposed(const cv::Mat& picture, double gain, double gamma) {
        cv::Mat table(1, 256, CV_8U);
        for (int i = 0; i < 256; ++i)
            table.at<std::uint8_t>(i) =
                cv::saturate_cast<std::uint8_t>(255 * gain * std::pow(i / 255.0, gamma));
        cv::Mat result;
        cv::LUT(picture, table, result);
        return result;
    }

    cv::Mat with_moved_part(const cv::Mat& picture, double share) {
        cv::Mat result = picture.clone();
        const cv::Size size(static_cast<int>(picture.cols * share), static_cast<int>(picture.rows * share));
        const cv::Point from(whole(picture.cols - size.width), whole(picture.rows - size.height));
        const cv::Point to(
            std::clamp(from.x + whole(picture.cols / 10) - picture.cols / 20, 0, picture.cols - size.width),
            std::clamp(from.y + whole(picture.rows / 10) - picture.rows / 20, 0, picture.rows - size.height));
        picture({from, size}).copyTo(result({to, size}));
        return result;
    }

    std::mt19937 engine_;
};

}  // namespace vitrine::player
