#pragma once

#include "analyzer/status/status_folder.hpp"
#include "analyzer/status/status_report.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// The thumbnail of a file. It has a folder of its own, as the child that writes it can write nothing beside.
/// @param thumbnails  STATE/thumbnails
/// @param id          as of its record
inline std::filesystem::path thumbnail_place(const std::filesystem::path& thumbnails, const std::string& id) {
    return thumbnails / id / "thumbnail.jpg";
}

/// Reads a whole JPEG; nothing where there is none, or where it is larger than a picture of ours can be.
std::optional<std::string> read_picture(const std::filesystem::path& file);

/// The thumbnails of the files on the status page: copied from the state directory, where the analysing
/// children write them, to the status folder.
class ThumbnailCopies {
  public:
    /// @param thumbnails  STATE/thumbnails
    explicit ThumbnailCopies(std::filesystem::path thumbnails) : thumbnails_(std::move(thumbnails)) {}

    /// Copies new thumbnails of ready files and removes those of files that are not on the page any more, in
    /// the state directory too.
    /// @throws std::system_error where a file in the folder cannot be written; all others are
    void update(const StatusFolder& folder, const std::vector<StatusEntry>& page);

    /// The ids of the thumbnails in the folder.
    const std::set<std::string>& ids() const { return ids_; }

    /// Paths of ready files on the page that had no thumbnail at the last update.
    const std::vector<std::string>& lacking() const { return lacking_; }

  private:
    void copy_if_changed(const StatusFolder& folder, const std::string& id);
    void read_folder(const StatusFolder& folder);
    void remove_old(const std::set<std::string>& wanted) const;

    std::filesystem::path thumbnails_;
    std::set<std::string> ids_;
    std::vector<std::string> lacking_;
    std::map<std::string, std::filesystem::file_time_type> copied_;  // by id, as they were in STATE
};

}  // namespace vitrine::analyzer
