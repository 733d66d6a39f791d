#pragma once

#include "analyzer/film/frame_source.hpp"

#include <chrono>
#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The size of a small film.
struct SmallFilmSize {
    int width = 0;  // px
    int height = 0;
};

/// Codes a film without its sound for a page: H.264 in MP4, which every browser plays, at most 640 px at its
/// longest side, with a key picture at least once a second, so that any moment is found at once. Its times
/// are the film's.
/// @param film      name to open it by
/// @param info      of the film
/// @param duration  of the film
/// @param file      replaced if there is one
/// @throws MediaError where the film cannot be decoded; std::runtime_error that names `file` where it cannot
/// be coded
SmallFilmSize write_small_film(const std::string& film, const MediaInfo& info,
                               std::chrono::nanoseconds duration, const std::filesystem::path& file);

/// @throws std::runtime_error that names the missing plugin, where this machine cannot code films
void require_film_encoder();

}  // namespace vitrine::analyzer
