#pragma once

#include "analyzer/status/status_folder.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace vitrine::analyzer {

/// A table for spreadsheets: for how many seconds each file was seen on a day. A path begins with "/", the
/// media folder, so that no name is taken for a formula.
/// @param texts  of the day, as the player writes them
std::string played_csv(std::string_view day, std::string_view texts);

/// Copies what the player leaves in the state directory to the status folder: the picture of the wall, and
/// for how long each file was seen.
class PlayerCopies {
  public:
    /// @param state  the state directory
    explicit PlayerCopies(std::filesystem::path state) : state_(std::move(state)) {}

    /// Copies the picture of the wall. @throws std::system_error
    void copy_wall(const StatusFolder& folder);

    /// Copies the times of the days that have changed. Tables of days that are too old go.
    /// @throws std::system_error
    void copy_played(const StatusFolder& folder);

    /// The folder has a picture of the wall.
    bool has_wall() const { return has_wall_; }

    /// The folder has the times of a day.
    bool has_played() const { return has_played_; }

  private:
    std::filesystem::path state_;
    bool has_wall_ = false;
    bool has_played_ = false;
    std::map<std::string, std::string> copied_;  // day -> the texts that it was made of, hashed
};

}  // namespace vitrine::analyzer
