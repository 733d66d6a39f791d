#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vitrine::analyzer {

/// A part of a file.
struct FilePart {
    std::uint64_t at = 0;
    std::uint64_t bytes = 0;

    bool operator==(const FilePart&) const = default;
};

/// True if a JPEG may have a film behind its picture: words of XMP say so near its beginning, or it ends as
/// Samsung's do. Bytes are only compared, so it may be called outside the sandbox.
/// @throws MediaError where the file cannot be read
bool may_hold_film(const std::string& path);

/// The film of a motion photo, as the photo's metadata name it.
struct InnerFilmPlace {
    bool is_promised = false;      // it says that it has one
    std::optional<FilePart> film;  // an MP4; none: there is none at the places that it names
};

/// Finds the film in a motion photo: by XMP of Google's two kinds, else by Samsung's list at the end.
/// @throws MediaError where the file cannot be read
InnerFilmPlace inner_film_place(const std::string& path);

}  // namespace vitrine::analyzer
