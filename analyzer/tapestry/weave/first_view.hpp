#pragma once

#include "analyzer/tapestry/synthesis/keyframes.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"
#include "base/state/tapestry.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::analyzer {

/// The keyframes of a first view: those that a person has chosen, and others at equal distances, as far as
/// there are frames that show a picture that stands.
/// @param count  of the others, at most
Keyframes first_keyframes(const Candidates& candidates, int count, const KeyframeChoice& chosen = {});

/// Lays bricks side by side with soft seams, so that a strip is there at once. Each brick loses a quarter of
/// its height; its region stays.
/// @param keyframe  returns the keyframe of a number in [0, brickwork.keyframes)
/// @return          CV_8UC3, as wide as the brickwork and as tall as a tapestry of it
cv::Mat plain_strip(const Brickwork& brickwork, const std::function<Keyframe(int)>& keyframe);

/// Writes a tapestry of one level of plain bricks and its index, in a time that does not depend on the film's
/// length; then kept frames and digits, and the index again. The index says that more follows.
/// @param head    path, bytes and mtime_ns of the film, and the key of the choice
/// @param folder  of its tiles, in the directory
/// @throws std::system_error, std::runtime_error; they name the file
void write_first_view(const std::filesystem::path& directory, const Tapestry& head, const std::string& folder,
                      const Film& film, const KeyframeChoice& chosen = {});

}  // namespace vitrine::analyzer
