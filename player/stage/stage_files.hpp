#pragma once

#include "player/scene/show_files.hpp"

#include <string>

namespace vitrine::player {

/// The files that a stage may show: all files of its folder; while a visitor looks into one folder, only the
/// files of that one.
class StageFiles {
  public:
    /// @param folder  below the media folder; empty: the whole media folder
    explicit StageFiles(std::string folder) : folder_(std::move(folder)) {}

    /// @param records  all files that may be shown, ordered by path
    void set(const RecordList& records, const ShowHints& hints);

    const std::string& folder() const { return folder_; }

    /// The files of the stage's folder, no matter which folder is open.
    const RecordList& all() const { return all_; }

    const ShowHints& hints() const { return hints_; }

    /// The files that pass both filters.
    RecordList shown() const { return all_.in_folder(opened_); }

    /// Limits the files to a folder that a visitor looks into. A folder without files is not opened.
    /// @param folder  below the media folder; empty: none
    void open(const std::string& folder);

    bool has_open_folder() const { return !opened_.empty(); }

    /// The folder that a visitor looks into; empty: none.
    const std::string& opened_folder() const { return opened_; }

  private:
    std::string folder_;
    RecordList all_;
    ShowHints hints_;
    std::string opened_;
};

}  // namespace vitrine::player
