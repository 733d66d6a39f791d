#include "player/playback/reader/reader_messages.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("an order arrives as it was sent") {
    const ReaderOrder order{.kind = MediaKind::photo,
                            .root = "/srv/media",
                            .path = "a folder/\xff.jpg",
                            .width = 1920,
                            .height = 1080,
                            .background = {.red = 1, .green = 2, .blue = 255},
                            .form = PictureForm::planes,
                            .begin = 1s,
                            .end = 2s,
                            .at = 3s,
                            .slots = {.count = 4, .bytes = 4096}};
    const std::optional<ReaderOrder> got = order_in(to_message(order));
    REQUIRE(got);
    CHECK(got->kind == order.kind);
    CHECK(got->root == order.root);
    CHECK(got->path == order.path);
    CHECK(got->width == order.width);
    CHECK(got->height == order.height);
    CHECK(got->background == order.background);
    CHECK(got->form == order.form);
    CHECK(got->begin == order.begin);
    CHECK(got->end == order.end);
    CHECK(got->at == order.at);
    CHECK(got->slots == order.slots);
}

TEST_CASE("a message of another kind or length is none") {
    const std::vector<std::byte> slot = to_message(SlotNote{.memory = 1, .slot = 2});
    CHECK(note_in<SlotNote>(slot)->slot == 2);
    CHECK_FALSE(note_in<PlayNote>(slot));
    CHECK_FALSE(note_in<SlotNote>(std::span(slot).first(slot.size() - 1)));
    CHECK_FALSE(note_in<SlotNote>({}));
    CHECK_FALSE(order_in(slot));
    CHECK_FALSE(failure_in(slot));
    CHECK_FALSE(failure_in({}));
    std::vector<std::byte> order = to_message(ReaderOrder{.root = "/media", .path = "a"});
    order.resize(order.size() - 3);  // the folder's name is longer than what is there
    CHECK_FALSE(order_in(order));
}

TEST_CASE(
    "the reason of a reader is cut where a log line would be too long, and an unknown owner is the file") {
    std::vector<std::byte> message =
        to_message(FailureNote{.owner = FaultOwner::transport, .text = "no answer"});
    CHECK(failure_in(message)->owner == FaultOwner::transport);
    CHECK(failure_in(message)->text == "no answer");
    message[sizeof(ReaderWord)] = std::byte{200};
    CHECK(failure_in(message)->owner == FaultOwner::file);
    message.resize(10'000, std::byte{'x'});
    CHECK(failure_in(message)->text.size() <= 500);
}
