#pragma once

#include "base/system/unique_fd.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace vitrine::analyzer {

/// The folder in the media folder that the analyzer writes. Others may do anything to it: links in it are
/// never followed, and nobody can know the name under which a file is written before it gets its own. What
/// stands in the place of a file or folder of ours goes, but for a folder that is not empty. All members
/// throw std::system_error where it cannot be written.
class StatusFolder {
  public:
    StatusFolder(std::filesystem::path root, std::string name)
        : root_(std::move(root)), name_(std::move(name)) {}

    /// Replaces a file as a whole, unless it has this content already.
    /// @param below  a folder in it; empty: the folder itself
    void write(const std::string& below, const std::string& name, std::string_view content) const;

    /// Removes what an analyzer that was killed has left half-written. Call it before the first write().
    void remove_unfinished(const std::string& below) const;

    /// The names in it that end like this.
    std::set<std::string> names(const std::string& below, std::string_view ending) const;

    void remove(const std::string& below, const std::string& name) const;

  private:
    UniqueFd open(const std::string& below) const;

    std::filesystem::path root_;
    std::string name_;
};

}  // namespace vitrine::analyzer
