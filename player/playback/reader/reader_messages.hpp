#pragma once

#include "base/media/colour.hpp"
#include "base/state/fault.hpp"
#include "base/state/record.hpp"
#include "player/playback/sample.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace vitrine::player {

// The messages between the player, the reader host and the readers. Each begins with its word. The player
// trusts no number of a reader: it may have been taken over by the file that it reads.

enum class ReaderWord : std::uint32_t {
    order = 1,  // player -> host: start a reader
    give_back,  // player -> reader: a slot is free again
    resize,     // player -> reader
    play_from,  // player -> reader
    picture,    // reader -> player
    failure,    // reader -> player: no more pictures
    end,        // host -> player, on the reader's socket: the process has ended
};

/// Equal parts of a piece of memory, each with room for one picture.
struct SlotShape {
    std::uint32_t count = 0;
    std::uint32_t bytes = 0;  // of one slot

    std::size_t all_bytes() const { return std::size_t{count} * bytes; }

    bool operator==(const SlotShape&) const = default;
};

/// The task of one reader: one photo, or a part of a film.
struct ReaderOrder {
    MediaKind kind = MediaKind::film;
    std::string root;  // the media folder
    std::string path;  // below it
    int width = 0;     // px of the upright pictures asked for
    int height = 0;
    Colour background;                  // of a photo
    PictureForm form{};                 // of a film's pictures
    std::chrono::nanoseconds begin{0};  // of a film's part, as in FilmPart
    std::chrono::nanoseconds end{0};
    std::chrono::nanoseconds at{0};
    SlotShape slots;
};

std::vector<std::byte> to_message(const ReaderOrder& order);

/// None: the message is not an order.
std::optional<ReaderOrder> order_in(std::span<const std::byte> message);

/// One slot of the memory of that number. The first memory is 0; each new one is one more.
struct SlotNote {
    static constexpr ReaderWord word = ReaderWord::give_back;
    std::uint32_t memory = 0;
    std::uint32_t slot = 0;
};

/// Another size of the pictures to come. New memory may come with it.
struct ResizeNote {
    static constexpr ReaderWord word = ReaderWord::resize;
    std::int32_t width = 0;  // px
    std::int32_t height = 0;
    std::uint32_t memory = 0;  // number of the memory that is used from now on
    SlotShape slots;
};

struct PlayNote {
    static constexpr ReaderWord word = ReaderWord::play_from;
    std::int64_t at = 0;  // ns
    std::uint32_t detail = 0;
    std::uint32_t unused = 0;
};

/// A picture that lies in a slot. Its layout decides where its planes lie (picture_slots.hpp).
struct PictureNote {
    static constexpr ReaderWord word = ReaderWord::picture;
    std::uint32_t memory = 0;
    std::uint32_t slot = 0;
    std::int32_t width = 0;  // px
    std::int32_t height = 0;
    std::uint32_t layout = 0;         // a PixelLayout
    std::uint32_t matrix = 0;         // a ColourCode::Matrix
    std::uint32_t is_full_range = 0;  // 0 or 1
    std::uint32_t unused = 0;
    std::int64_t stream_time = 0;  // ns
    std::int64_t duration = 0;     // ns
    std::uint64_t loop = 0;
    std::int64_t spent = 0;  // ns
};

/// The way in which a reader's process ended.
struct EndNote {
    static constexpr ReaderWord word = ReaderWord::end;
    std::int32_t signal = 0;     // 0: none
    std::int32_t exit_code = 0;  // if there is no signal
    std::int32_t error = 0;      // errno if no process could be started; 0: it was started
};

/// The reason why a reader gives no more pictures.
struct FailureNote {
    FaultOwner owner = FaultOwner::file;
    std::string text;  // in plain words
};

std::vector<std::byte> to_message(const FailureNote& failure);

/// None: the message is not a failure. The text is cut at a length that a log can take.
std::optional<FailureNote> failure_in(std::span<const std::byte> message);

template <typename Note> std::vector<std::byte> to_message(const Note& note) {
    static_assert(std::has_unique_object_representations_v<Note>, "a note has no gaps");
    std::vector<std::byte> bytes(sizeof(ReaderWord) + sizeof note);
    std::memcpy(bytes.data(), &Note::word, sizeof(ReaderWord));
    std::memcpy(bytes.data() + sizeof(ReaderWord), &note, sizeof note);
    return bytes;
}

/// None: the message is not such a note.
template <typename Note> std::optional<Note> note_in(std::span<const std::byte> message) {
    Note note;
    ReaderWord word{};
    if (message.size() != sizeof word + sizeof note) return std::nullopt;
    std::memcpy(&word, message.data(), sizeof word);
    if (word != Note::word) return std::nullopt;
    std::memcpy(&note, message.data() + sizeof word, sizeof note);
    return note;
}

}  // namespace vitrine::player
