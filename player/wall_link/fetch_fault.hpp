#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace vitrine::player {

/// Why the leader's files could not be fetched the last time, as vitrine-wall-fetch tells it in a file.
class FetchFault {
  public:
    /// @param file  `wall.fetch_fault`
    explicit FetchFault(std::filesystem::path file) : file_(std::move(file)) {}

    /// Reads the file, at most once in some seconds.
    /// @param now  never goes back
    void look(std::chrono::nanoseconds now);

    /// One line, of at most 300 bytes. Empty: all files were fetched.
    const std::string& text() const { return text_; }

  private:
    std::filesystem::path file_;
    std::optional<std::chrono::nanoseconds> looked_;
    std::string text_;
};

}  // namespace vitrine::player
