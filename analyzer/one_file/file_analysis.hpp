#pragma once

#include "analyzer/one_file/analysis_outputs.hpp"
#include "base/settings/settings.hpp"
#include "base/state/record.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::analyzer {

// The commands of vitrine-analyzer that look at one file.

/// Functions that are called while a file is analysed. Each may be empty.
struct AnalysisEvents {
    /// Gets the new shots of a film whenever one is over, and one shot again when its place in the store
    /// becomes known.
    std::function<void(const MediaRecord& part)> grown;
    std::function<void()> progressed;  // a picture was decoded
};

/// The record of one file as it is now: with its shots, or with the reason why there are none. A film that
/// turns out to be damaged behind its first shots keeps them, and has the reason too.
///
/// @param file     anywhere; its path in the record is relative to settings.media.root where it lies in there
/// @param outputs  by-products to write
/// @throws std::system_error where there is no such file
MediaRecord analyse_file(const std::filesystem::path& file, const Settings& settings,
                         const AnalysisOutputs& outputs = {}, const AnalysisEvents& events = {});

/// Prints that record on the standard output, and with `outputs.growth` each shot before, a line each, and an
/// empty line a second while pictures are decoded. Other output of the process goes to the standard error
/// from then on: libraries print too. This process enters the sandbox of a reader for good.
/// @throws std::system_error
void print_analysis(const std::filesystem::path& file, const Settings& settings,
                    const AnalysisOutputs& outputs);

/// Writes the thumbnail of a file whose record is in the catalogue. This process enters the sandbox of a
/// reader for good.
/// @return whether there is one now
/// @throws MediaError where the file cannot be read
bool write_thumbnail(const std::filesystem::path& file, const Settings& settings);

/// Writes the sheet that shows how the file's regions came about, as PNG. This process enters the sandbox of
/// a reader for good, and holds the sheet open before.
/// @return the record
/// @throws MediaError where there is nothing to show; std::system_error
MediaRecord explain_file(const std::filesystem::path& file, const std::string& sheet,
                         const Settings& settings);

}  // namespace vitrine::analyzer
