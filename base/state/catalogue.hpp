#pragma once

#include "base/state/record.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// The directory of records, one file ID.json for each medium. Only the analyzer writes it. Any number of
/// readers see each record whole or not at all.
class Catalogue {
  public:
    /// Called for each record file that cannot be read or parsed, with its name and the reason.
    using Complaint = std::function<void(const std::string& file, const std::string& reason)>;

    /// @param directory  store() creates it with its parents if it is missing
    explicit Catalogue(std::filesystem::path directory);

    const std::filesystem::path& directory() const { return directory_; }

    /// All readable records, ordered by path. A missing directory is an empty catalogue.
    std::vector<MediaRecord> load(const Complaint& complain = {}) const;

    std::optional<MediaRecord> find(const std::string& path) const;

    /// Replaces the record of its path by write, fsync and rename. @throws std::system_error
    void store(const MediaRecord& record) const;

    /// Removes the record of this path, if there is one. @throws std::system_error
    void remove(const std::string& path) const;

  private:
    std::filesystem::path file_of(const std::string& path) const;

    std::filesystem::path directory_;
};

}  // namespace vitrine
