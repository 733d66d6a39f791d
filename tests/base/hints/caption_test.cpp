#include "base/hints/caption.hpp"

#include "base/hints/folder_hints.hpp"
#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("a caption file is named like a photo or film, with .txt behind") {
    for (const char* name : {"a.jpg.txt", "A.JPG.TXT", "b c.heic.txt", "film.mp4.txt"})
        CHECK_MESSAGE(is_caption_file(name), name);
    for (const char* name : {"notes.txt", "a.jpg", "a.jpg.txt.bak", ".jpg.txt", "a.txt.txt", "a.jpg.url.txt"})
        CHECK_MESSAGE(!is_caption_file(name), name);
}

TEST_CASE("a caption is one line of UTF-8") {
    CHECK(caption_text("\xef\xbb\xbf  Oma am See,\r\n1987\n").text == "Oma am See,  1987");
    CHECK(caption_text("\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d").fault.empty());
    CHECK(caption_text(" \n").text.empty());
    CHECK(caption_text("caf\xe9").fault == "it is not UTF-8");
    CHECK(caption_text(std::string(1 << 20, 'x')).fault == "it is longer than 500 bytes");
    CHECK(caption_text(std::string(1 << 20, 'x')).text.empty());
}

TEST_CASE("where nothing is written, the name may be the caption") {
    CHECK(caption_of({.written = "Oma", .own = "Opa", .path = "a/01_See.jpg"}) == "Oma");
    CHECK(caption_of({.written = "", .own = "Opa", .path = "a/01_See.jpg"}) == "Opa");
    CHECK(caption_of({.written = "", .own = std::string(501, 'x'), .path = ""}).empty());
    CHECK(caption_of({.written = "", .own = "", .path = "a/20s 01_Am_See.jpg"}) == "Am See");
    CHECK(caption_of({}).empty());
}

TEST_CASE("the year stands before a caption, or alone") {
    const std::chrono::local_days day{std::chrono::year(2019) / 5 / 1};
    CHECK(caption_of({.written = "", .own = "Lake", .path = "", .day = day}) == "2019 · Lake");
    CHECK(caption_of({.written = "", .own = "", .path = "", .day = day}) == "2019");
}

TEST_CASE("captions of files reach the player with the hints of folders") {
    FolderHints hints;
    hints["a/b.jpg"].caption = "Oma \"am\" See";
    const FolderHints read = folder_hints_from_json(to_json(hints));
    CHECK(hints_of("a/b.jpg", read).caption == "Oma \"am\" See");
    CHECK(!hints_of("a/c.jpg", read).caption);
}
