#pragma once

#include "analyzer/film/film_frame.hpp"
#include "analyzer/tapestry/weave/candidate_writer.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace vitrine::analyzer {

/// Keeps a film's frames in its tapestry's folder while it is decoded for whatever reason, so that nobody has
/// to decode it again to weave it. A full disk is no reason to fail: there are none then.
class KeptFrames {
  public:
    /// @param directory   of the tapestry; made where there is none
    /// @param most_bytes  that they may take; a film that needs more has none
    KeptFrames(std::filesystem::path directory, std::uint64_t most_bytes);
    KeptFrames(const KeptFrames&) = delete;
    KeptFrames& operator=(const KeptFrames&) = delete;

    /// Leaves no half file behind.
    ~KeptFrames();

    void saw(const FilmFrame& frame);

    /// From now on they are there, and whole.
    void finish(std::chrono::nanoseconds duration, const FilmContent& content);

  private:
    void give_up();

    std::filesystem::path directory_;
    std::uint64_t most_bytes_;
    std::unique_ptr<CandidateWriter> writer_;  // none: given up, or finished
};

/// The file with the frames of that film; nothing where they were not kept.
std::optional<UniqueFd> kept_frames(const std::filesystem::path& directory);

void remove_kept_frames(const std::filesystem::path& directory);

}  // namespace vitrine::analyzer
