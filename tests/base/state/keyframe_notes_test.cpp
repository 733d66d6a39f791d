#include "base/state/keyframe_notes.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace vitrine;

TEST_CASE("each film keeps its note, whatever bytes its name has, until it is taken back") {
    const TemporaryDirectory state;
    CHECK(read_keyframe_notes(state.path).empty());
    const std::string odd = "\xff\xfe \"odd\".mp4";
    write_keyframe_note(state.path, "summer/lake.mp4", "strike = [1]\n");
    write_keyframe_note(state.path, odd, "keyframes = [2, 3.5]\n");
    write_keyframe_note(state.path, "summer/lake.mp4", "strike = [1, 7]\n");
    CHECK(read_keyframe_notes(state.path) ==
          KeyframeNotes{{"summer/lake.mp4", "strike = [1, 7]\n"}, {odd, "keyframes = [2, 3.5]\n"}});
    write_keyframe_note(state.path, odd, "");
    CHECK(read_keyframe_notes(state.path) == KeyframeNotes{{"summer/lake.mp4", "strike = [1, 7]\n"}});
}

TEST_CASE("a file of notes that holds none is none") {
    const TemporaryDirectory state;
    for (const char* text :
         {"", "notes", "{}", R"({"version":2,"films":[]})", R"({"version":1,"films":[{"path":"a"}]})"}) {
        state.write(keyframe_notes_file, text);
        CHECK(read_keyframe_notes(state.path).empty());
    }
}

TEST_CASE("one film more than may have notes is refused, and the others keep theirs") {
    const TemporaryDirectory state;
    std::string films;
    for (std::size_t k = 0; k < max_keyframe_notes; ++k)
        films +=
            (k > 0 ? "," : "") + (R"({"path":"f)" + std::to_string(k)) + R"(","keyframes":"strike=[1]"})";
    state.write(keyframe_notes_file, R"({"version":1,"films":[)" + films + "]}");
    CHECK_THROWS_AS(write_keyframe_note(state.path, "more.mp4", "strike = [1]\n"), std::runtime_error);
    CHECK(read_keyframe_notes(state.path).size() == max_keyframe_notes);
    write_keyframe_note(state.path, "f7", "strike = [2]\n");
    CHECK(read_keyframe_notes(state.path).at("f7") == "strike = [2]\n");
}
