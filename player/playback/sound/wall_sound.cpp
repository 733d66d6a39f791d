#include "player/playback/sound/wall_sound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds max_apart = 80ms;  // largest offset of sound and picture
constexpr std::size_t max_ending = 4;                 // only a device that does not answer leads to more
constexpr std::size_t max_told = 1000;

}  // namespace

void WallSound::follow(std::span<const AudibleShot> shots, std::chrono::nanoseconds moment) {
    look_after();
    std::vector<AudibleShot> sound(shots.begin(), shots.end());
    std::erase_if(failed_, [&](SourceId source) {
        return std::ranges::find(shots, source, &AudibleShot::source) == shots.end();
    });
    std::erase_if(sound, [&](const AudibleShot& shot) {
        return shot.duration() <= 0ns || failed_.contains(shot.source) || !is_stored(shot);
    });
    const AudibleShot* one = chosen_sound(sound);
    if (one && one->is_elsewhere) one = nullptr;
    const auto origin = one ? moment - one->local : 0ns;
    if (now_ &&
        (!one || one->source != now_->shot.source || std::chrono::abs(origin - now_->origin) > max_apart))
        leave();
    if (one && !now_ && ending_.size() < max_ending) start(*one, origin);
}

/// Files of the media folder are not decoded in this process.
bool WallSound::is_stored(const AudibleShot& shot) {
    if (shot.stored && !shot.stored->is_dropped) return true;
    tell_once(fmt::format("'{}' is silent until its sound is in the store", shot.path), false);
    return false;
}

/// @pre is_stored(shot)
void WallSound::start(const AudibleShot& shot, std::chrono::nanoseconds origin) {
    if (shot.stored->file.empty()) {
        failed_.insert(shot.source);
        return tell_once(fmt::format("'{}' has no sound that can be played", shot.path), false);
    }
    const SoundPart part{.file = places_.store + "/" + shot.stored->file,
                         .begin = shot.begin,
                         .end = shot.end,
                         .origin = origin};
    now_.emplace(
        Playing{.shot = shot, .origin = origin, .sound = std::make_unique<FilmSound>(part, make_sink_)});
}

void WallSound::leave() {
    now_->sound->leave();
    ending_.push_back(std::move(now_->sound));
    now_.reset();
}

void WallSound::look_after() {
    std::erase_if(ending_, [](const auto& sound) { return sound->has_ended(); });
    if (!now_) return;
    if (now_->sound->is_heard()) complaint_.clear();
    if (!now_->sound->has_ended()) return;
    failed_.insert(now_->shot.source);
    const std::optional<PlaybackFailure> failure = now_->sound->failure();
    if (failure && failure->is_of_film)
        tell_once(fmt::format("the sound of '{}' is not played: {}", now_->shot.path, failure->text), true);
    else if (failure && complaint_ != failure->text)
        events_.push_back({.text = complaint_ = failure->text, .is_trouble = true});
    now_.reset();
}

void WallSound::tell_once(const std::string& text, bool is_trouble) {
    if (told_.size() >= max_told) told_.clear();
    if (told_.insert(text).second) events_.push_back({.text = text, .is_trouble = is_trouble});
}

}  // namespace vitrine::player
