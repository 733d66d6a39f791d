#include "player/playback/reader/film_reader.hpp"

#include "base/state/media_error.hpp"
#include "player/playback/film_loop.hpp"
#include "player/playback/reader/free_slots.hpp"
#include "player/playback/sample_queue.hpp"

#include <unistd.h>

#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t decoded_ahead = 2;  // pictures; those in the slots come on top
constexpr std::chrono::hours for_ever{24};

/// A reader decodes in software, so its pictures lie in plain memory.
PictureForm plain(PictureForm form) {
    return form == PictureForm::shared ? PictureForm::planes : form;
}

PictureNote note_of(const LoopedSample& picture, const SlotNote& place, std::chrono::nanoseconds spent) {
    const Sample& sample = picture.sample;
    return {.memory = place.memory,
            .slot = place.slot,
            .width = sample.width,
            .height = sample.height,
            .layout = static_cast<std::uint32_t>(sample.layout),
            .matrix = static_cast<std::uint32_t>(sample.colours.matrix),
            .is_full_range = sample.colours.is_full_range ? 1U : 0U,
            .stream_time = sample.stream_time.count(),
            .duration = picture.duration.count(),
            .loop = picture.loop,
            .spent = spent.count()};
}

/// The film of one reader. The calling thread hands over its pictures, another one follows the player.
class HandedFilm {
  public:
    HandedFilm(const ReaderOrder& order, const std::string& file, const MessageSocket& player,
               const UniqueFd& memory)
        : player_(player),
          slots_(std::make_shared<PictureSlots>(memory, order.slots, PictureSlots::Use::writing)),
          queue_(decoded_ahead),
          film_({.file = file,
                 .begin = order.begin,
                 .end = order.end,
                 .width = order.width,
                 .height = order.height,
                 .at = order.at},
                queue_, {.form = plain(order.form)}) {}

    /// Follows the player until it closes its end, then ends the process.
    [[noreturn]] void follow_player() {
        while (const std::optional<Message> message = player_.receive(1)) {
            if (const auto slot = note_in<SlotNote>(message->bytes)) slots_.give_back(*slot);
            if (const auto play = note_in<PlayNote>(message->bytes))
                film_.play_from(static_cast<Detail>(play->detail), std::chrono::nanoseconds(play->at));
            if (const auto size = note_in<ResizeNote>(message->bytes)) resize(*size, message->files);
        }
        ::_exit(0);
    }

    /// Hands over the film's pictures until no more come. @return the reason
    std::string hand_over() {
        while (const std::optional<LoopedSample> picture = next_picture()) {
            const FreeSlots::Place place = slots_.wait_for_slot();
            if (!copy_picture(picture->sample, place.memory->writable_slot(place.name.slot)))
                return "a picture of the film is larger than its place";
            if (!player_.send(to_message(note_of(*picture, place.name, film_.spent()))))
                return "the player takes no more pictures";
        }
        return film_.failure().value_or("the film has ended");
    }

  private:
    void resize(const ResizeNote& size, const std::vector<UniqueFd>& files) {
        if (!files.empty())
            slots_.change_memory(
                std::make_shared<PictureSlots>(files.front(), size.slots, PictureSlots::Use::writing),
                size.memory);
        film_.resize(size.width, size.height);
    }

    std::optional<LoopedSample> next_picture() {
        while (!queue_.wait(for_ever) && !queue_.is_closed()) {
        }
        return queue_.take_if([](const LoopedSample&) { return true; });
    }

    const MessageSocket& player_;  // outlives this
    FreeSlots slots_;
    SampleQueue queue_;
    FilmLoop film_;  // after the queue that it fills
};

}  // namespace

void read_film(const ReaderOrder& order, const std::string& file, const MessageSocket& player,
               const UniqueFd& memory) {
    // Neither the film nor the thread is ever destroyed: a decoder that hangs would keep the process alive.
    auto* const film = new HandedFilm(order, file, player, memory);
    std::thread([film] { film->follow_player(); }).detach();
    throw MediaError(MediaState::failed, film->hand_over());
}

}  // namespace vitrine::player
