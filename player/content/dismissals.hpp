#pragma once

#include "base/state/record.hpp"

#include <map>
#include <string>
#include <vector>

namespace vitrine::player {

/// Files that somebody wants off the wall, though they are in the folder: until the player starts anew, or
/// they change.
class Dismissals {
  public:
    void add(const MediaRecord& record) { dismissed_[record.path] = record; }

    /// Those that are left. What has changed since it was dismissed, or is gone, is not dismissed any more.
    std::vector<MediaRecord> filtered(const std::vector<MediaRecord>& records);

    bool contains(const std::string& path) const { return dismissed_.contains(path); }

    std::vector<std::string> paths() const;

  private:
    std::map<std::string, MediaRecord> dismissed_;
};

}  // namespace vitrine::player
