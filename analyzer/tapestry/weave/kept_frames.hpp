#pragma once

#include "analyzer/film/film_frame.hpp"
#include "analyzer/tapestry/weave/candidate_writer.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace vitrine::analyzer {

/// Keeps a film's frames in its tapestry's folder while it is decoded for another purpose, so that weaving
/// need not decode it again. On a full disk no frames are kept; that is no failure.
class KeptFrames {
  public:
    /// @param directory   folder of the tapestry; made where there is none
    /// @param max_bytes  for the frames; a film that needs more has none kept
    KeptFrames(std::filesystem::path directory, std::uint64_t max_bytes,
               int brick_height = usual_brick_height);
    KeptFrames(const KeptFrames&) = delete;
    KeptFrames& operator=(const KeptFrames&) = delete;

    /// Leaves no half file behind.
    ~KeptFrames();

    void saw(const FilmFrame& frame);

    /// Completes the file and gives it its name. @param film  see CandidateWriter
    void finish(const MediaRecord& film, const FilmContent& content,
                const std::optional<cv::Rect>& active = {});

    /// px of the frames; empty where none are kept.
    cv::Size frame() const { return writer_ ? writer_->frame() : cv::Size(); }

  private:
    void give_up();

    std::filesystem::path directory_;
    std::uint64_t max_bytes_;
    std::unique_ptr<CandidateWriter> writer_;  // null: given up or finished
};

/// The file with the kept frames; nothing where none were kept.
std::optional<UniqueFd> kept_frames(const std::filesystem::path& directory);

void remove_kept_frames(const std::filesystem::path& directory);

}  // namespace vitrine::analyzer
