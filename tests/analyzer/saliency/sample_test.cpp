#include "analyzer/saliency/sample.hpp"

#include <doctest/doctest.h>

using namespace vitrine::analyzer;

TEST_CASE("frames of any shape have maps, however narrow they are") {
    for (const cv::Size size : {cv::Size(2, 2), cv::Size(16384, 2), cv::Size(2, 16384), cv::Size(3840, 64)}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        const cv::Mat grey(size, CV_8UC3, cv::Scalar::all(90));
        const Sample sample = sample_of({.frame = grey, .before = grey}, {});
        CHECK(sample.motion.size() == map_size(size));
        CHECK(sample.image.size() == map_size(size));
        CHECK(map_size(size).area() > 0);
    }
}
