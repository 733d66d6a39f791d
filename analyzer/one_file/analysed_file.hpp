#pragma once

#include "analyzer/film/frame_source.hpp"
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

    std::string name() const { return file_.string(); }

    std::uint64_t bytes() const { return bytes_; }

    std::int64_t mtime_ns() const { return mtime_ns_; }

    /// Its path as its record has it.
    const std::string& path() const { return path_; }

    /// The same record with path, bytes and mtime of the file.
    MediaRecord stamped(MediaRecord record) const;

    /// Opens it from its first frame. @throws MediaError where it cannot be read
    std::unique_ptr<FrameSource> open() const;

    std::filesystem::path thumbnail() const;

    /// The folder of its tapestry, if it is a film.
    std::filesystem::path tapestry() const;

    StorePlace store_place() const;

  private:
    std::filesystem::path file_;
    const Settings& settings_;
    std::string path_;
    std::uint64_t bytes_ = 0;
    std::int64_t mtime_ns_ = 0;
    bool is_plain_ = false;  // neither a folder nor a device
};

/// The stages of the analysis as the settings want them.
AnalysisSettings analysis_settings(const Settings::Analyzer& from);

}  // namespace vitrine::analyzer
