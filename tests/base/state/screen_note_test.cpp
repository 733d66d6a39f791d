#include "base/state/screen_note.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("the size of the screens is known once the player has noted it, and the last note holds") {
    const TemporaryDirectory directory;
    CHECK(noted_screen_side(directory.path) == 0);
    note_screen_side(directory.path, 1280);
    CHECK(noted_screen_side(directory.path) == 1280);
    note_screen_side(directory.path, 3840);
    CHECK(noted_screen_side(directory.path) == 3840);
}

TEST_CASE("a note that is none is as good as none") {
    const TemporaryDirectory directory;
    for (const char* text :
         {"", "\n", "1280", "-5\n", "0\n", "99999\n", "wide\n", "1280 720\n", "99999999999999999999\n"}) {
        CAPTURE(text);
        replace_file(directory.path / "screen", text);
        CHECK(noted_screen_side(directory.path) == 0);
    }
}
