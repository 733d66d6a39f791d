#pragma once

#include <opencv2/core.hpp>

namespace vitrine::analyzer {

/// The kind of one picture.
enum class PictureKind {
    picture,
    title,  // words on a ground of one grey
    plain   // black, white or one grey
};

struct PictureLook {
    PictureKind kind = PictureKind::picture;
    cv::Rect stands_out;  // px of a picture of `size`: all that is not the ground of a title
};

/// @param bgr   CV_8UC3, not empty, without bars
/// @param size  at which it is looked at: words must still be seen
PictureLook look_at(const cv::Mat& bgr, cv::Size size);

}  // namespace vitrine::analyzer
