#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace vitrine::player {

/// The files of the store for which the wall of a follower waits, in a file of one line each:
/// vitrine-wall-fetch fetches them before all others.
class WantedFiles {
  public:
    /// @param file  STATE/wanted
    explicit WantedFiles(std::filesystem::path file) : file_(std::move(file)) {}

    /// True: it is time to tell which files are wanted. @param now  never goes back
    bool is_due(std::chrono::nanoseconds now) const;

    /// Writes the file, if other files are wanted. One that cannot be written is left as it is: then all
    /// files are fetched in their order.
    void tell(const std::set<std::string>& files, std::chrono::nanoseconds now);

  private:
    std::filesystem::path file_;
    std::optional<std::chrono::nanoseconds> told_at_;
    std::optional<std::set<std::string>> told_;
};

}  // namespace vitrine::player
