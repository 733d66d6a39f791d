#pragma once

#include <string>

namespace vitrine::player {

/// Where the files lie.
struct MediaPlaces {
    std::string media;  // the media folder
    std::string store;  // of the analyzer; a shot that it has is played from there
};

}  // namespace vitrine::player
