#pragma once

#include "base/settings/settings.hpp"
#include "base/system/unique_fd.hpp"

#include <string>

namespace vitrine {

/// Settings as a file in memory for programs that are started later: they have what was right when it was
/// read, whatever somebody is writing into the file of settings meanwhile.
class SettingsSnapshot {
  public:
    /// @throws std::system_error
    explicit SettingsSnapshot(const Settings& settings);

    /// @throws std::system_error
    void replace(const Settings& settings);

    /// Can be read by this user's processes for as long as this lives.
    std::string path() const;

  private:
    UniqueFd file_;
};

}  // namespace vitrine
