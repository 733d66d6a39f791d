#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/tapestry/synthesis/keyframes.hpp"
#include "analyzer/tapestry/synthesis/weave.hpp"
#include "analyzer/tapestry/weave/candidates.hpp"
#include "analyzer/tapestry/weave/weave_plan.hpp"
#include "base/hints/keyframe_choice.hpp"
#include "base/state/tapestry.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace vitrine::analyzer {

/// The choice of a film's keyframes.
struct WeaveChoice {
    int max_levels = 32;
    bool is_uniform = false;  // keyframes at equal distances; no frames are compared
    KeyframeChoice chosen{};  // by a person; without any, all are chosen by clustering
};

/// The frames of a film that are kept to weave it.
struct Film {
    std::unique_ptr<Candidates> candidates;
    std::chrono::nanoseconds duration{0};
};

/// Opens the frames that were kept of a film. @throws as Candidates
Film film_of(UniqueFd frames, FaceDetector* faces);

/// Reads a film to its end and finds its shots.
/// @param seen  gets each frame
/// @return      duration, size and shots without regions
/// @throws MediaError where it is broken
MediaRecord watched_film(FrameSource& source, const std::function<void(const FilmFrame&)>& seen);

/// Reads a film to its end.
/// @param directory  gets a nameless file of the frames while they are needed
/// @throws MediaError where it is broken or holds no picture
Film gathered(FrameSource& source, const std::filesystem::path& directory, FaceDetector* faces);

std::vector<Keyframes> chosen_keyframes(const Candidates& candidates, const WeaveChoice& choice,
                                        const RunTasks& run);

constexpr int tile_file_width = 512;  // px

Brickwork brickwork_of(const Keyframes& keyframes, cv::Size brick);

/// The index entry of a level. @param keyframes  numbers of the candidates
TapestryLevel level_of(const Keyframes& keyframes, const Candidates& candidates);

/// Weaves some keyframes of a film into a strip in memory. CV_8UC3.
cv::Mat woven_strip(const Film& film, const Keyframes& keyframes, const RetargetSettings& settings,
                    const RunTasks& run);

/// The settings of writing a pyramid.
struct PyramidSettings {
    RetargetSettings retarget;
    std::uint64_t max_bytes = 0;  // for tiles, about: a level that would exceed it is not begun; 0: any
    bool is_last = true;          // false: a sharper tapestry of the same film follows
    std::filesystem::path index;  // folder of the index; empty: that of the tiles
};

// Suffixes of folders of tiles.
constexpr const char* first_suffix = "-first";  // of a first view, see first_view.hpp
constexpr const char* sharp_suffix = "-sharp";  // of a sharper tapestry

/// Makes a folder for tiles that no weaving has used before, so that readers of the one before lose nothing.
/// @return its name
std::string new_tile_folder(const std::filesystem::path& directory);

/// Puts a finished tapestry of the same film in the place of another, whose tiles stay: a player may show
/// them.
/// @param directory  folder of both tapestries' tiles and of the index to replace
/// @param index      folder of the finished tapestry's index; it is removed
void replace_tapestry(const std::filesystem::path& directory, const std::filesystem::path& index);

/// Weaves all levels of a film into a folder.
class PyramidWriter {
  public:
    /// @param directory, film, settings, run  outlive this
    PyramidWriter(const std::filesystem::path& directory, const Film& film, const PyramidSettings& settings,
                  const RunTasks& run)
        : directory_(directory), film_(film), settings_(settings), run_(run) {}

    /// Writes the tiles, and the index anew after each level, so that the coarsest level can be shown while
    /// finer ones are made. Goes on where an earlier weaving into the same tile folder was interrupted; the
    /// files do not depend on that. Removes the tiles of other weavings last, when no index names them.
    /// @param tapestry  path, bytes and mtime_ns of the film
    /// @return          the index
    /// @throws std::system_error, std::runtime_error; they name the file
    Tapestry write(Tapestry tapestry, const WeavePlan& plan) const;

  private:
    const std::filesystem::path& index_folder() const {
        return settings_.index.empty() ? directory_ : settings_.index;
    }

    void write_newest_level(const Tapestry& tapestry, const Keyframes& keyframes) const;

    const std::filesystem::path& directory_;
    const Film& film_;
    const PyramidSettings& settings_;
    const RunTasks& run_;
};

}  // namespace vitrine::analyzer
