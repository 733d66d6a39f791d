#pragma once

#include "analyzer/film/active_picture.hpp"
#include "analyzer/film/film_frame.hpp"
#include "analyzer/tapestry/weave/candidate_file.hpp"
#include "base/state/record.hpp"
#include "base/system/unique_fd.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

constexpr int usual_brick_height = 100;  // px: a tapestry is 150 px tall

/// Keeps the frames of a film that may become keyframes, two a second, while it is decoded: small signatures
/// in memory, pictures of the size of a brick in a file. A picture with bars is kept in the size of the
/// frame, since a part of it will be the brick. Of a film beyond two hours fewer frames a second are kept.
/// Source: Video Tapestries 4.1, the precomputation.
class CandidateWriter {
  public:
    static constexpr std::size_t two_hours = 14'400;  // frames

    /// @param file          empty, for reading and writing
    /// @param max_frames    frames to keep
    /// @param brick_height  px
    explicit CandidateWriter(UniqueFd file, std::size_t max_frames = two_hours,
                             int brick_height = usual_brick_height)
        : file_(std::move(file)), max_frames_(max_frames), brick_height_(brick_height) {}

    /// Passes over frames that are not later than the last one or have another size: their stream is broken.
    /// @throws std::system_error where there is no room
    void push(const FilmFrame& frame);

    bool is_empty() const { return entries_.empty(); }

    /// The size of the file so far.
    std::uint64_t bytes() const { return static_cast<std::uint64_t>(written_); }

    /// @param film  duration, which is at least up to the last frame; size and shots with their regions where
    ///              they are known
    /// @param active  the picture within its bars, px of the frames; none: as these frames show it
    /// @return        the complete file
    UniqueFd finish(const MediaRecord& film, const FilmContent& content,
                    const std::optional<cv::Rect>& active = {});

    /// px of the frames; empty before the first.
    cv::Size frame() const { return frame_; }

  private:
    void thin();
    void append(const void* data, std::size_t bytes);

    UniqueFd file_;
    std::size_t max_frames_;
    int brick_height_;
    cv::Size frame_;  // px of the pushed frames
    ActivePictureFinder bars_;
    std::chrono::nanoseconds interval_{0};
    std::chrono::nanoseconds due_{0};
    std::chrono::nanoseconds last_{-1};
    std::int64_t written_ = 0;
    std::vector<CandidateEntry> entries_;
};

/// Makes a file without a name, which is gone as soon as nobody has it open.
/// @throws std::system_error
UniqueFd nameless_file(const std::filesystem::path& directory);

/// The largest middle part of a picture that has the shape of a brick, px of the picture.
cv::Rect cut_to(cv::Size picture, cv::Size brick);

/// The brick for frames of a size: of that height, its width even and within [0.4, 3] times that.
cv::Size brick_for(cv::Size frame, int height = usual_brick_height);

}  // namespace vitrine::analyzer
