#pragma once

#include "analyzer/film/media_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The files that a process needs beside the one that it looks at.
struct ReaderNeeds {
    std::vector<std::filesystem::path> folders;    // written below; made where they are not there
    std::filesystem::path film_folder;             // one more if the file is a film; empty: none
    std::vector<std::string> models;               // files to read; empty names are passed over
    bool holds_film = false;                       // the photo may have a film, an MP4, inside
    std::vector<std::filesystem::path> libraries;  // folders to read below, where they are there
};

/// Lets this process do nothing any more but look at one file: loads what the file's format needs, then
/// enters the sandbox. The first bytes of the file tell its format; they are only compared. What is no medium
/// gets no folders. A folder that cannot be made is left out: a full disk is met where the folder is written.
/// @throws std::system_error, std::logic_error like enter_sandbox()
void enter_reader_sandbox(const MediaFile& file, const ReaderNeeds& needs);

}  // namespace vitrine::analyzer
