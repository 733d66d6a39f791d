#pragma once

#include "analyzer/tapestry/synthesis/weave.hpp"
#include "base/state/tapestry.hpp"

#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The files of one level while it is woven: its tiles, and every few tiles a note that tells where to go on.
class LevelFiles {
  public:
    /// Finds out how far an earlier weaving has come.
    /// @param tapestry  its folder, height and tile_width are used; outlives this, as does directory
    LevelFiles(const std::filesystem::path& directory, const Tapestry& tapestry, std::size_t level,
               const Brickwork& brickwork);

    /// The progress to hand to weave_level().
    const WovenSoFar& done() const { return done_; }

    /// Writes the columns that weave_level() hands over. @throws std::system_error, std::runtime_error; they
    /// name the file
    void add(const cv::Mat& columns, const WovenSoFar& done);

    /// Writes the rest after the last column.
    void finish();

    /// Removes the note. Call when the level is complete and the index says so.
    void remove_note();

  private:
    std::filesystem::path folder() const;
    std::filesystem::path note(std::size_t tiles) const;
    void go_on_from(std::size_t tiles, const cv::Mat& rest);
    void write(const cv::Mat& tile);

    const std::filesystem::path& directory_;
    const Tapestry& tapestry_;
    std::size_t level_;
    std::vector<TileSpan> spans_;
    WovenSoFar done_;
    int next_ = 0;                // number of the next tile file
    cv::Mat pending_;             // columns that are in no file yet
    std::filesystem::path note_;  // the newest note
};

}  // namespace vitrine::analyzer
