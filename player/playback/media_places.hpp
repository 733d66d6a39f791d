#pragma once

#include "player/scene/shot_request.hpp"

#include <optional>
#include <string>

namespace vitrine::player {

/// The folders that the files lie in.
struct MediaPlaces {
    std::string media;  // the media folder
    std::string store;  // the analyzer's; a shot that it has is played from there
};

/// A file that can be opened, and the request in that file's own times and size.
struct ShotFile {
    std::string path;
    ShotRequest request;
};

/// The file in the media folder.
ShotFile media_file(const ShotRequest& request, const MediaPlaces& places);

/// The copy in the store; nothing where the record knows of none, or the store has lost it since.
std::optional<ShotFile> stored_file(const ShotRequest& request, const MediaPlaces& places);

}  // namespace vitrine::player
