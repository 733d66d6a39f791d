#pragma once

#include "player/playback/sample.hpp"

#include <filesystem>
#include <string>

namespace vitrine::player {

constexpr int numbered_width = 160;  // px
constexpr int numbered_height = 96;

/// A film of 160 x 96 of which each picture carries its number: a bright band above, below it ten blocks,
/// bright for the bits of the number that are set, the lowest left.
struct NumberedFilm {
    int pictures = 100;  // up to 1024
    int rate = 30;       // a second
    std::string chain;   // encoder and muxer in gst-launch's words
};

/// A new folder, gone with its content when this is.
struct Folder {
    std::filesystem::path path;

    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();
};

/// @throws std::runtime_error where it cannot be made
void write_film(const std::string& file, const NumberedFilm& film);

/// The number that a picture carries, at whatever size; -1: it is no upright numbered picture.
int number(const Sample& sample);

/// Writes a photo of 40 x 20, the left half red, the right half blue: a BMP.
void write_photo(const std::string& file);

}  // namespace vitrine::player
