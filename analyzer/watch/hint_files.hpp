#pragma once

#include "analyzer/watch/media_folder.hpp"
#include "base/hints/folder_hints.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// What the files `.vitrine.toml` in the media folder say; tells it to the player in STATE/hints.json. Logs.
class HintFiles {
  public:
    static constexpr std::size_t max_bytes = 1U << 16;  // of one of them

    /// @param folder  outlives this
    HintFiles(const MediaFolder& folder, std::filesystem::path told)
        : folder_(folder), told_(std::move(told)) {}

    /// Reads them anew. @param paths  of the files whose folders count
    void read(const std::vector<std::string>& paths);

    const FolderHints& hints() const { return hints_; }

    /// What is wrong with them: file, line and what is allowed.
    const std::vector<std::string>& faults() const { return faults_; }

  private:
    void read_one(const std::string& folder);
    void tell();

    const MediaFolder& folder_;
    std::filesystem::path told_;
    FolderHints hints_;
    std::vector<std::string> faults_;
    std::set<std::string> complaints_;  // faults that were told
    std::string written_;               // what is in the file
};

}  // namespace vitrine::analyzer
