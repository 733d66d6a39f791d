#include "player/playback/reader/reader_link.hpp"

#include "base/state/media_error.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace {

/// Signals by which a process ends through what it does itself. SIGSYS comes from the sandbox.
constexpr std::array own_signals{SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE, SIGTRAP, SIGSYS};

ReaderEnd end_of(const EndNote& note) {
    if (note.error != 0)
        return {.text =
                    fmt::format("no reader can be started: {}", std::generic_category().message(note.error))};
    if (std::ranges::find(own_signals, note.signal) != own_signals.end())
        return {.text = fmt::format("its reader crashed ({})", ::strsignal(note.signal)),
                .has_crashed = true};
    if (note.signal != 0) return {.text = "its reader was killed from outside"};
    return {.text = fmt::format("its reader ended without a reason ({})", note.exit_code)};
}

PictureIntake::GiveBack give_back_to(std::shared_ptr<const MessageSocket> reader) {
    return [reader = std::move(reader)](const SlotNote& slot) { reader->send(to_message(slot)); };
}

}  // namespace

ReaderLink::ReaderLink(MessageSocket reader, const ReaderOrder& order, const UniqueFd& memory)
    : socket_(std::make_shared<const MessageSocket>(std::move(reader))),
      form_(order.form),
      intake_(order.kind == MediaKind::film ? order.end - order.begin : std::chrono::nanoseconds(0),
              give_back_to(socket_)),
      slots_(order.slots) {
    intake_.add_memory(std::make_shared<PictureSlots>(memory, slots_, PictureSlots::Use::reading));
}

/// Larger pictures get new memory. The reader changes to it before its first picture of the new size.
void ReaderLink::resize(int width, int height) {
    const std::lock_guard lock(mutex_);
    const std::optional<SlotShape> wanted = slots_for(slots_.count, width, height, form_);
    if (!wanted) return;
    try {
        ResizeNote note{.width = width, .height = height, .memory = memory_, .slots = slots_};
        if (wanted->bytes <= slots_.bytes) {
            socket_->send(to_message(note));
            return;
        }
        const UniqueFd memory = new_slot_memory(*wanted);
        intake_.add_memory(std::make_shared<PictureSlots>(memory, *wanted, PictureSlots::Use::reading));
        note.slots = slots_ = *wanted;
        note.memory = ++memory_;
        const std::array<int, 1> files{memory.get()};
        socket_->send(to_message(note), files);
    } catch (const std::exception& error) {
        log::debug("the pictures of a reader keep their size: {}", error.what());
    }
}

void ReaderLink::play_from(Detail detail, std::chrono::nanoseconds at) {
    socket_->send(to_message(PlayNote{.at = at.count(), .detail = static_cast<std::uint32_t>(detail)}));
}

std::optional<ReaderPicture> ReaderLink::next() {
    try {
        while (const std::optional<Message> message = socket_->receive()) {
            if (is_end(*message)) break;
            if (std::optional<ReaderPicture> picture = picture_in(*message)) return picture;
        }
    } catch (const MediaError& error) {
        end_ = {.text = error.what(), .has_crashed = true};
        stop();
    }
    if (end_.text.empty()) end_.text = "its reader has gone";
    return std::nullopt;
}

/// None: a picture in memory that the player does not have any more.
std::optional<ReaderPicture> ReaderLink::picture_in(const Message& message) {
    const auto note = note_in<PictureNote>(message.bytes);
    if (!note) throw MediaError(MediaState::failed, "its reader gave an answer that cannot be");
    const std::lock_guard lock(mutex_);
    std::optional<LoopedSample> picture = intake_.take(*note);
    if (!picture) return std::nullopt;
    return ReaderPicture{.picture = *std::move(picture), .spent = std::chrono::nanoseconds(note->spent)};
}

/// A failure is followed by the end of the process, which says no more.
bool ReaderLink::is_end(const Message& message) {
    if (const std::optional<FailureNote> failure = failure_in(message.bytes)) {
        end_ = {.text = failure->text};
        return true;
    }
    const auto end = note_in<EndNote>(message.bytes);
    if (end) end_ = end_of(*end);
    return end.has_value();
}

}  // namespace vitrine::player
