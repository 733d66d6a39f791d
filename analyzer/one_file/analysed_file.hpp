#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/film/media_file.hpp"
#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/store/store_place.hpp"
#include "base/settings/settings.hpp"
#include "base/state/record.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace vitrine::analyzer {

/// One file to analyse: its identity, read once, and the places of its by-products in the state directory.
class AnalysedFile {
  public:
    /// @param file      anywhere; its path in records is relative to settings.media.root where it lies there
    /// @param settings  outlives this
    /// @throws std::system_error where there is no such file
    AnalysedFile(const std::filesystem::path& file, const Settings& settings);

    const Settings& settings() const { return settings_; }

    /// The file itself: what it is called, and by which name it is opened.
    const MediaFile& media() const { return file_; }

    /// The same record with path, bytes and mtime of the file.
    MediaRecord stamped(MediaRecord record) const;

    /// Tells when it was taken. Reads it: call it in the sandbox.
    MediaOrigin origin() const;

    /// Opens it from its first frame. @throws MediaError where it cannot be read
    std::unique_ptr<FrameSource> open() const;

    std::filesystem::path thumbnail() const;  // in a folder of its own

    /// The folder of its tapestry, if it is a film.
    std::filesystem::path tapestry() const;

    StorePlace store_place() const;

  private:
    MediaFile file_;
    const Settings& settings_;
};

/// The stages of the analysis as the settings want them.
AnalysisSettings analysis_settings(const Settings::Analyzer& from);

}  // namespace vitrine::analyzer
