#pragma once

#include "base/settings/settings.hpp"
#include "base/system/unique_fd.hpp"

#include <string>

namespace vitrine {

/// A copy of the settings in a file in memory, for child processes that start later. They get the settings as
/// they were when the file was read, even if somebody edits it meanwhile.
class SettingsSnapshot {
  public:
    /// @throws std::system_error
    explicit SettingsSnapshot(const Settings& settings);

    /// @throws std::system_error
    void replace(const Settings& settings);

    /// The path of the file. Processes of this user can read it for as long as this object lives.
    std::string path() const;

  private:
    UniqueFd file_;
};

}  // namespace vitrine
