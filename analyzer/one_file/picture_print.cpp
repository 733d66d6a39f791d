#include "analyzer/one_file/picture_print.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace vitrine::analyzer {

PicturePrint print_of(const cv::Mat& bgr) {
    constexpr int side = PicturePrint::side;
    cv::Mat grey, shades, edges, mean, deviation;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::resize(grey, shades, {side, side}, 0, 0, cv::INTER_AREA);
    cv::Laplacian(grey, edges, CV_16S);
    cv::meanStdDev(edges, mean, deviation);
    PicturePrint print{.shades = {}, .sharpness = deviation.at<double>(0) * deviation.at<double>(0)};
    for (int y = 0; y < side; ++y)
        print.shades.insert(print.shades.end(), shades.ptr<std::uint8_t>(y),
                            shades.ptr<std::uint8_t>(y) + side);
    return print;
}

}  // namespace vitrine::analyzer
