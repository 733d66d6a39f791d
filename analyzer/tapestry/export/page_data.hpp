#pragma once

#include "base/state/tapestry.hpp"

#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The film of a page.
struct PageFilm {
    std::string name;  // any bytes
    int width = 0;     // px
    int height = 0;
};

constexpr const char* page_film_name = "film.mp4";

/// Writes what the page of a tapestry reads of it: tapestry.js with the index, and for each tile a script
/// with its JPEG and its zoom fields. A page that a browser opens as a file may read scripts, but no other
/// files' content. docs/catalogue.md has the format.
/// @param woven   folder of the tapestry
/// @param folder  gets the scripts
/// @throws std::system_error, std::runtime_error; they name the file
void write_page_data(const std::filesystem::path& woven, const PageFilm& film,
                     const std::filesystem::path& folder);

}  // namespace vitrine::analyzer
