#pragma once

#include "base/system/directory_watch.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::analyzer {

/// The film whose tapestry a visitor waits for, as the player says in the state directory.
class WantedFilm {
  public:
    /// @param state    the state directory
    /// @param changed  called from the loop when path() is another one
    WantedFilm(EventLoop& loop, std::filesystem::path state, std::function<void()> changed);
    WantedFilm(const WantedFilm&) = delete;
    WantedFilm& operator=(const WantedFilm&) = delete;
    ~WantedFilm() = default;

    /// The path of the film's record; "" for none.
    const std::string& path() const { return path_; }

    /// Reads the player's wish. Call from time to time too: a wish becomes old.
    void look();

  private:
    void handle_events();

    std::filesystem::path state_;
    std::function<void()> changed_;
    std::string path_;
    DirectoryWatch watch_;
    EventLoop::Source events_;
};

}  // namespace vitrine::analyzer
