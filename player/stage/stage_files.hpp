#pragma once

#include "player/scene/files/show_files.hpp"

#include <string>

namespace vitrine::player {

/// The files that a stage may show: all files of its folder.
class StageFiles {
  public:
    /// @param folder  below the media folder; empty: the whole media folder
    explicit StageFiles(std::string folder) : folder_(std::move(folder)) {}

    /// @param records  all files that may be shown, ordered by path
    void set(const RecordList& records, const ShowHints& hints);

    const std::string& folder() const { return folder_; }

    const RecordList& all() const { return all_; }

    const ShowHints& hints() const { return hints_; }

  private:
    std::string folder_;
    RecordList all_;
    ShowHints hints_;
};

}  // namespace vitrine::player
