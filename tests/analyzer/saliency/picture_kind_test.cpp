#include "analyzer/saliency/picture_kind.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

using namespace vitrine::analyzer;

namespace {

const cv::Size look_size(160, 90);

cv::Mat title_on(const cv::Scalar& ground) {
    cv::Mat picture(360, 640, CV_8UC3, ground);
    cv::putText(picture, "THE DURIAN MOVIE", {100, 190}, cv::FONT_HERSHEY_SIMPLEX, 1.5, {230, 230, 230}, 4);
    return picture;
}

/// Coarse coloured noise.
cv::Mat scene() {
    cv::Mat coarse(9, 16, CV_8UC3);
    cv::RNG(1).fill(coarse, cv::RNG::UNIFORM, 0, 120);
    cv::Mat picture;
    cv::resize(coarse, picture, {640, 360}, 0, 0, cv::INTER_CUBIC);
    return picture + cv::Scalar(20, 60, 130);
}

}  // namespace

TEST_CASE("black, white and grey are plain, also with the noise of a coding") {
    for (const int level : {0, 128, 255}) {
        cv::Mat picture(360, 640, CV_8UC3, cv::Scalar::all(level));
        cv::Mat noise(picture.size(), CV_8UC3);
        cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 4);
        CAPTURE(level);
        CHECK(look_at(picture + noise, look_size).kind == PictureKind::plain);
    }
}

TEST_CASE("words on a plain ground are a title, and all of them stand out") {
    const PictureLook look = look_at(title_on(cv::Scalar::all(0)), look_size);
    CHECK(look.kind == PictureKind::title);
    CHECK(look.stands_out.x <= 27);
    CHECK(look.stands_out.br().x >= 130);
}

TEST_CASE("a thing on a plain ground is a picture") {
    cv::Mat picture(360, 640, CV_8UC3, cv::Scalar::all(0));
    cv::circle(picture, {300, 180}, 60, {40, 60, 240}, cv::FILLED, cv::LINE_AA);
    CHECK(look_at(picture, look_size).kind == PictureKind::picture);
}

TEST_CASE("a scene is a picture, also a dark one, and so is one colour") {
    CHECK(look_at(scene(), look_size).kind == PictureKind::picture);
    CHECK(look_at(scene() * .2, look_size).kind == PictureKind::picture);
    CHECK(look_at(cv::Mat(90, 160, CV_8UC3, cv::Scalar(50, 70, 190)), look_size).kind ==
          PictureKind::picture);
}
