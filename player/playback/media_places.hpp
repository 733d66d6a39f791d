#pragma once

#include "player/scene/shot_request.hpp"

#include <optional>
#include <string>

namespace vitrine::player {

/// The folders of the files.
struct MediaPlaces {
    std::string media;  // the media folder
    std::string store;  // the analyzer's store; shots in it are played from there
};

/// A file that can be opened, and the request in that file's own times and size.
struct ShotFile {
    std::string path;
    ShotRequest request;
};

/// The file in the media folder.
ShotFile media_file(const ShotRequest& request, const MediaPlaces& places);

/// The copy in the store. None: the record names none, or the store has lost it since.
std::optional<ShotFile> stored_file(const ShotRequest& request, const MediaPlaces& places);

}  // namespace vitrine::player
