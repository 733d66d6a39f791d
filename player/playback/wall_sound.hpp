#pragma once

#include "player/playback/film_sound.hpp"
#include "player/playback/media_places.hpp"
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

/// What is to be told of the sound.
struct SoundEvent {
    std::string text;
    bool is_trouble = false;
};

/// What of the walls is heard: one film at a time, for as long as it is on a wall. Whatever becomes of the
/// sound, nobody waits for it.
class WallSound {
  public:
    WallSound(MediaPlaces places, SoundSink make_sink)
        : places_(std::move(places)), make_sink_(std::move(make_sink)) {}

    /// To be called with every picture of the walls. What is heard and not among the shots any more, or not
    /// at the same place of its loop, fades out.
    /// @param shots  those that may be heard
    /// @param moment  of the picture, by the monotonic clock
    void follow(std::span<const AudibleShot> shots, std::chrono::nanoseconds moment);

    /// Nothing is heard from here on.
    void fall_silent() { follow({}, {}); }

    /// What is heard, or gets ready to be; none: nothing.
    std::optional<SourceId> heard() const { return now_ ? std::optional(now_->shot.source) : std::nullopt; }

    /// Each is told once.
    std::vector<SoundEvent> take_events() { return std::exchange(events_, {}); }

  private:
    struct Playing {
        AudibleShot shot;
        std::chrono::nanoseconds origin{0};
        std::unique_ptr<FilmSound> sound;
    };

    void start(const AudibleShot& shot, std::chrono::nanoseconds origin);
    void leave();
    void look_after();
    void tell_once(const std::string& text, bool is_trouble);

    MediaPlaces places_;
    SoundSink make_sink_;
    std::optional<Playing> now_;
    std::set<SourceId> failed_;
    std::vector<std::unique_ptr<FilmSound>> ending_;
    std::string complaint_;       // of the device, as last told
    std::set<std::string> told_;  // of films
    std::vector<SoundEvent> events_;
};

}  // namespace vitrine::player
