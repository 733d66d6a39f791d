#include "player/stage/folder_words.hpp"

#include <doctest/doctest.h>

#include <memory>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("a word fits into the box for its text, and stays in its middle") {
    const Box box{{100, 50}, {300, 90}};
    const Box wide = word_place(box, {.width = 800, .height = 80, .rgba = {}});
    CHECK(wide == Box{{100, 60}, {300, 80}});
    const Box high = word_place(box, {.width = 50, .height = 100, .rgba = {}});
    CHECK(high == Box{{190, 50}, {210, 90}});
}

TEST_CASE("a name without a picture is not drawn") {
    FolderWords words("/nonexistent");
    Frame frame{.names = {{.text = "trips", .box = {{0, 0}, {100, 20}}}}};
    words.draw(frame);
    CHECK(frame.words.empty());
}

TEST_CASE("a photo's own caption is on the wall, below one of the operator, and tells the year on its day") {
    auto record = std::make_shared<MediaRecord>();
    record->path = "a.jpg";
    record->origin.caption = "Lake";
    record->origin.taken = TimeTaken{.at = std::chrono::sys_days(std::chrono::year(2019) / 5 / 1),
                                     .source = TimeSource::camera_clock};
    const auto caption = [&](const ShowHints& hints, CaptionChoice choice = CaptionChoice::written) {
        return caption_on_wall("a.jpg", hints, record, choice);
    };
    ShowHints hints;
    CHECK(caption(hints) == "Lake");
    CHECK(caption({{.path = "a.jpg", .hints = {.caption = "See"}}}) == "See");
    hints.today = std::chrono::local_days(std::chrono::year(2026) / 5 / 1);
    CHECK(caption(hints) == "2019 · Lake");
    hints.today = std::chrono::local_days(std::chrono::year(2026) / 5 / 2);
    CHECK(caption(hints) == "Lake");
    record->origin.caption.clear();
    CHECK(caption(hints).empty());
    CHECK(caption(hints, CaptionChoice::names) == "a");
    hints.today = std::chrono::local_days(std::chrono::year(2026) / 5 / 1);
    CHECK(caption(hints) == "2019");
    record->origin.taken->source = TimeSource::file;
    CHECK(caption(hints).empty());
}
