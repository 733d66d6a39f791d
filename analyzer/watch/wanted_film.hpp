#pragma once

#include "base/system/directory_watch.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::analyzer {

/// The film whose tapestry a visitor waits for, as the player says in the state directory. Hears there of the
/// keyframes, too, that a technician chooses.
class WantedFilm {
  public:
    /// Called from the loop.
    struct Calls {
        std::function<void()> wanted;  // path() is another one
        std::function<void()> noted;   // there are other keyframe notes (base/state/keyframe_notes.hpp)
    };

    /// @param state  the state directory
    WantedFilm(EventLoop& loop, std::filesystem::path state, Calls calls);
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
    Calls calls_;
    std::string path_;
    DirectoryWatch watch_;
    EventLoop::Source events_;
};

}  // namespace vitrine::analyzer
