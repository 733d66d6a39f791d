#pragma once

#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The thumbnail of a file. It has a folder of its own, as the child that writes it can write nothing beside.
/// @param thumbnails  STATE/thumbnails
/// @param id          as of its record
inline std::filesystem::path thumbnail_place(const std::filesystem::path& thumbnails, const std::string& id) {
    return thumbnails / id / "thumbnail.jpg";
}

}  // namespace vitrine::analyzer
