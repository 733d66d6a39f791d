#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace vitrine {

// The player tells the analyzer which keyframes a technician has chosen by touch: docs/catalogue.md, "A
// tapestry".

/// Below the state directory; only the player writes it.
constexpr const char* keyframe_notes_file = "keyframes.json";

/// The films that may have a note.
constexpr std::size_t max_keyframe_notes = 1000;

/// The text of each note, by the path of the film's record. The text is what a file `FILM.tapestry.toml` may
/// hold.
using KeyframeNotes = std::map<std::string, std::string>;

/// The notes; none where the file is not there or cannot be read.
/// @param state  the state directory
KeyframeNotes read_keyframe_notes(const std::filesystem::path& state);

/// Replaces the note of one film. @param path  as in the film's record, any bytes
/// @param text  "": the film has no note any more
/// @throws std::system_error; std::runtime_error if there are too many notes
void write_keyframe_note(const std::filesystem::path& state, const std::string& path,
                         const std::string& text);

}  // namespace vitrine
