#pragma once

#include "analyzer/film/film_frame.hpp"
#include "base/state/record.hpp"

#include <filesystem>
#include <vector>

namespace vitrine::analyzer {

/// A small picture of one file with its I-Region drawn in it, for the status folder. The first shot is known
/// only once it is over: until then a few frames are kept.
class Thumbnail {
  public:
    /// @param file  a JPEG that is replaced as a whole
    explicit Thumbnail(std::filesystem::path file) : file_(std::move(file)) {}

    /// Keeps a frame for later. Frames come in the order of time.
    void add_frame(const FilmFrame& frame);

    /// Draws the first shot; further calls do nothing. A full disk is no reason to fail.
    /// @param record  must have that shot
    void write(const MediaRecord& record);

  private:
    const FilmFrame* frame_of(const Shot& shot) const;

    std::filesystem::path file_;
    std::vector<FilmFrame> frames_;
    bool is_written_ = false;
};

}  // namespace vitrine::analyzer
