#pragma once

#include "analyzer/saliency/face_detector.hpp"
#include "analyzer/tapestry/brickwork.hpp"
#include "analyzer/tapestry/frame_signature.hpp"
#include "analyzer/video/video_frame.hpp"
#include "base/system/unique_fd.hpp"

#include <filesystem>
#include <vector>

namespace vitrine {

/// The frames of a film that may become keyframes, two a second: small signatures in memory, pictures of a
/// brick's size in a file without a name. A film beyond two hours gets them less often.
class Candidates {
  public:
    /// @param brick      px that they are kept in; what does not fit its shape is cut off at both sides
    /// @param directory  where there is room for the pictures
    /// @param faces      outlives this; null: none are looked for
    Candidates(cv::Size brick, const std::filesystem::path& directory, FaceDetector* faces);

    /// @param frame  later than the last
    void push(const VideoFrame& frame);

    const std::vector<FrameSignature>& signatures() const { return signatures_; }

    cv::Size brick() const { return brick_; }

    /// @throws std::system_error where the file cannot be read
    Keyframe keyframe(int number) const;

  private:
    struct Kept {
        std::int64_t slot = 0;  // of the file
        std::vector<cv::Rect> faces;
    };

    void thin();

    cv::Size brick_;
    UniqueFd file_;
    FaceDetector* detector_;  // lent
    std::chrono::nanoseconds interval_;
    std::chrono::nanoseconds due_{0};
    std::int64_t slots_ = 0;
    std::vector<FrameSignature> signatures_;
    std::vector<Kept> kept_;
};

/// The brick for frames of a size: 100 px tall, its width even and within [0.4, 3] times that.
cv::Size brick_for(cv::Size frame);

}  // namespace vitrine
