#pragma once

#include "player/playback/media_places.hpp"
#include "player/playback/sound/film_sound.hpp"
#include "player/scene/chosen_sound.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// News of the sound, for the log.
struct SoundEvent {
    std::string text;
    bool is_trouble = false;
};

/// The sound of the walls: one film at a time, for as long as it is on a wall. The player never waits for it.
/// A film is silent until its sound is in the store.
class WallSound {
  public:
    WallSound(MediaPlaces places, SoundSink make_sink)
        : places_(std::move(places)), make_sink_(std::move(make_sink)) {}

    /// Updates the sound to the shots on the walls. Call with every frame. Fades a sound out if its shot is
    /// gone, or if it is not at the same place of its loop as the picture.
    /// @param shots   the shots that may be heard; if another box lets the chosen one be heard, this is
    /// silent
    /// @param moment  time of the frame, by the monotonic clock
    void follow(std::span<const AudibleShot> shots, std::chrono::nanoseconds moment);

    /// The source that is heard, or prepares to be. None: silence.
    std::optional<SourceId> heard() const { return now_ ? std::optional(now_->shot.source) : std::nullopt; }

    /// The events since the last call.
    std::vector<SoundEvent> take_events() { return std::exchange(events_, {}); }

  private:
    struct Playing {
        AudibleShot shot;
        std::chrono::nanoseconds origin{0};
        std::unique_ptr<FilmSound> sound;
    };

    bool is_stored(const AudibleShot& shot);
    void start(const AudibleShot& shot, std::chrono::nanoseconds origin);
    void leave();
    void look_after();
    void tell_once(const std::string& text, bool is_trouble);

    MediaPlaces places_;
    SoundSink make_sink_;
    std::optional<Playing> now_;
    std::set<SourceId> failed_;
    std::vector<std::unique_ptr<FilmSound>> ending_;
    std::string complaint_;       // the last complaint about the device
    std::set<std::string> told_;  // texts about films, each logged once
    std::vector<SoundEvent> events_;
};

}  // namespace vitrine::player
