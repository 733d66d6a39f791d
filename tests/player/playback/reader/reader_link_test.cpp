#include "player/playback/reader/reader_link.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// The player's end of a reader whose part the test plays.
struct Ends {
    explicit Ends(MediaKind kind = MediaKind::film) {
        order.kind = kind;
        order.slots = slots_for(2, 32, 20, PictureForm::bgra).value();
        const UniqueFd memory = new_slot_memory(order.slots);
        auto [ours, theirs] = message_sockets();
        link = std::make_unique<ReaderLink>(std::move(ours), order, memory);
        reader = std::make_unique<MessageSocket>(std::move(theirs));
    }

    template <typename Note> void say(const Note& note) const { CHECK(reader->send(to_message(note))); }

    ReaderOrder order{.width = 32, .height = 20, .begin = 0s, .end = 1s};
    std::unique_ptr<ReaderLink> link;
    std::unique_ptr<MessageSocket> reader;
};

PictureNote picture() {
    return {.width = 32, .height = 20, .layout = static_cast<std::uint32_t>(PixelLayout::bgra), .spent = 7};
}

}  // namespace

TEST_CASE("a reader's pictures come with what they cost, and their slots go back") {
    const Ends ends;
    ends.say(picture());
    std::optional<ReaderPicture> got = ends.link->next();
    REQUIRE(got);
    CHECK(got->spent == 7ns);
    got.reset();
    const std::optional<Message> answer = ends.reader->receive();
    REQUIRE(answer);
    CHECK(note_in<SlotNote>(answer->bytes)->slot == 0);
}

TEST_CASE("an answer that cannot be ends the reader, and counts as its crash") {
    const std::vector<std::vector<std::byte>> answers{
        std::vector<std::byte>(3),
        std::vector<std::byte>(5000),
        std::vector<std::byte>(100'000),
        to_message(SlotNote{}),
        to_message(PictureNote{.slot = 7, .width = 32, .height = 20, .layout = 1}),
    };
    for (const std::vector<std::byte>& answer : answers) {
        CAPTURE(answer.size());
        const Ends ends;
        CHECK(ends.reader->send(answer));
        CHECK_FALSE(ends.link->next());
        CHECK(ends.link->end().has_crashed);
        CHECK_FALSE(ends.reader->receive());  // the host sees this, and ends the reader
    }
}

TEST_CASE("descriptors that a reader sends do not reach the player") {
    const Ends ends;
    const std::array<int, 1> files{ends.reader->fd()};
    CHECK(ends.reader->send(to_message(picture()), files));
    CHECK(ends.link->next());
}

TEST_CASE("a crash of the reader is the file's, a kill from outside is not") {
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE, SIGSYS, SIGKILL, SIGTERM}) {
        CAPTURE(signal);
        const Ends ends;
        ends.say(EndNote{.signal = signal});
        CHECK_FALSE(ends.link->next());
        CHECK(ends.link->end().has_crashed == (signal != SIGKILL && signal != SIGTERM));
        CHECK_FALSE(ends.link->end().text.empty());
    }
}

TEST_CASE("the reason of a reader is the reason") {
    const Ends ends;
    ends.say(FailureNote{.owner = FaultOwner::file, .text = "the film is damaged"});
    CHECK_FALSE(ends.link->next());
    CHECK(ends.link->end().text == "the film is damaged");
    CHECK_FALSE(ends.link->end().has_crashed);
}

TEST_CASE("larger pictures get new memory, smaller ones lie in the memory that is there") {
    const Ends ends;
    ends.link->resize(16, 10);
    const std::optional<Message> smaller = ends.reader->receive(1);
    CHECK(smaller->files.empty());
    CHECK(note_in<ResizeNote>(smaller->bytes)->memory == 0);
    ends.link->resize(64, 40);
    const std::optional<Message> larger = ends.reader->receive(1);
    CHECK(larger->files.size() == 1);
    const auto note = note_in<ResizeNote>(larger->bytes);
    REQUIRE(note);
    CHECK(note->memory == 1);
    CHECK(note->slots.bytes >= 64 * 40 * 4);
    PictureNote large = picture();
    large.memory = 1;
    large.width = 64;
    large.height = 40;
    ends.say(large);
    CHECK(ends.link->next()->picture.sample.width == 64);
}

TEST_CASE("who leaves does not wait for a reader that says nothing") {
    const Ends ends;
    std::thread waiting([&] { CHECK_FALSE(ends.link->next()); });
    ends.link->stop();
    ends.link->leave();
    waiting.join();
}
