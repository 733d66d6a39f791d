#pragma once

#include <filesystem>
#include <string>

namespace vitrine::player {

/// Tells the analyzer for as long as it exists that a visitor waits for a film's tapestry. Logs.
class TapestryWish {
  public:
    /// @param state  the state directory
    /// @param path   of the film's record
    TapestryWish(std::filesystem::path state, std::string path);
    TapestryWish(const TapestryWish&) = delete;
    TapestryWish& operator=(const TapestryWish&) = delete;
    TapestryWish(TapestryWish&&) = delete;
    TapestryWish& operator=(TapestryWish&&) = delete;
    ~TapestryWish();

  private:
    std::filesystem::path state_;
    std::string path_;
};

}  // namespace vitrine::player
