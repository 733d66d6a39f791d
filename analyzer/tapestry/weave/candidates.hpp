#pragma once

#include "analyzer/faces/face_detector.hpp"
#include "analyzer/tapestry/synthesis/brickwork.hpp"
#include "analyzer/tapestry/synthesis/frame_signature.hpp"
#include "analyzer/tapestry/weave/candidate_file.hpp"
#include "base/state/record.hpp"
#include "base/system/unique_fd.hpp"

#include <chrono>
#include <optional>
#include <vector>

namespace vitrine::analyzer {

enum class FaceSearch { done, left_out };

/// The frames of a film that may become keyframes, as CandidateWriter has left them. Their signatures are in
/// memory, 25 MB for two hours; their pictures stay in the file.
class Candidates {
  public:
    static constexpr int max_side = 4096;  // px of bricks and frames

    /// @param faces  outlives this; null: no faces are searched
    /// @throws std::runtime_error where the file is of another kind or ends too early, std::system_error
    Candidates(UniqueFd file, FaceDetector* faces);

    /// The signatures in time order, at least one.
    const std::vector<FrameSignature>& signatures() const { return signatures_; }

    cv::Size brick() const { return brick_; }

    /// px of the frames that were kept.
    cv::Size frame() const { return frame_; }

    /// The picture within the film's bars, px of the frames.
    cv::Rect active() const { return active_; }

    /// The film's duration.
    std::chrono::nanoseconds duration() const { return duration_; }

    /// The film as it was known when its frames were kept: its size and its shots. No shots: none are known.
    const MediaRecord& film() const { return film_; }

    const FilmContent& content() const { return content_; }

    /// The picture of a frame, CV_8UC3, of the brick's size.
    /// @throws std::system_error, std::runtime_error where the file cannot be read
    cv::Mat picture(int number) const;

    /// A frame as a keyframe. Its faces are searched at the first call that wants them: most frames of a long
    /// film are never asked for.
    /// @throws std::system_error, std::runtime_error where the file cannot be read
    Keyframe keyframe(int number, FaceSearch search = FaceSearch::done) const;

  private:
    /// The part of a kept picture that becomes the brick.
    struct KeptPart {
        cv::Size whole;  // px of the kept picture
        cv::Rect part;
    };

    struct Kept {
        std::int64_t offset = 0;
        std::int64_t bytes = 0;
    };

    void read(void* into, std::size_t bytes, std::int64_t offset) const;
    void read_sizes(const CandidateFileEnd& end);
    void read_record(const CandidateFileEnd& end);
    cv::Mat kept_picture(int number) const;
    KeptPart kept_part(int number, cv::Size whole) const;
    cv::Mat as_brick(const cv::Mat& kept, const KeptPart& part) const;
    const Shot* shot_at(int number) const;
    cv::Rect active_part(const Shot* shot, cv::Size kept) const;
    std::vector<cv::Point> region_in(const Shot& shot, int number, const KeptPart& part) const;
    std::vector<cv::Rect> faces_in(const cv::Mat& picture) const;

    UniqueFd file_;
    FaceDetector* detector_;  // outlives this
    cv::Size brick_;
    cv::Size frame_;   // px; pictures with bars have it
    cv::Rect active_;  // px of the frame: the picture within its bars
    std::chrono::nanoseconds duration_{0};
    FilmContent content_;
    MediaRecord film_;
    std::vector<FrameSignature> signatures_;
    std::vector<Kept> kept_;
    mutable std::vector<std::optional<std::vector<cv::Rect>>> faces_;  // one a frame; none: not searched yet
};

}  // namespace vitrine::analyzer
