#pragma once

#include "analyzer/faces/face_detector.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"
#include "base/geometry/box.hpp"

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Processor time of all threads since this was made, seconds.
class CpuTime {
  public:
    CpuTime() : begin_(now()) {}

    double seconds() const { return now() - begin_; }

  private:
    static double now() {
        timespec time{};
        ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double begin_;
};

/// A level with its pictures.
struct LoadedLevel {
    Brickwork brickwork;
    std::vector<Keyframe> keyframes;

    std::vector<Keyframe> bricks(const TileSpan& span) const;
};

/// Reads a film to its end, with its shots and their regions.
/// @param brick_height  px
Film analysed(FrameSource& source, FaceDetector* detector, int brick_height);

LoadedLevel loaded(const Film& film, const Keyframes& keyframes);

/// The brickwork as it is, and scaled to the height of the tapestry.
cv::Mat bricks_picture(const LoadedLevel& level);
cv::Mat squeezed(const LoadedLevel& level);

/// Keyframes side by side, as many as fit, as tall as the tapestry.
cv::Mat filmstrip(const LoadedLevel& level);

/// Pairs of neighbouring keyframes that differ by less than 20 grey levels (root of the mean square), at the
/// size of a brick.
int pairs_alike(const LoadedLevel& level);

cv::Mat woven(const LoadedLevel& level, TileQuality quality, int region_weight);

/// The bidirectional distance of a part of a strip to its bricks, a channel value, all patches weighing 1.
double distance(const LoadedLevel& level, const TileSpan& span, const cv::Mat& strip);

/// Mean squared difference of neighbouring pixels.
struct Gradients {
    double inside = 0;         // over all columns
    double tile_borders = 0;   // at the begin of a tile, and at the end of its fixed columns
    double brick_borders = 0;  // at the borders between bricks of a row
    double row_inside = 0;     // over all rows
    double row_border = 0;     // between the two rows of bricks
};

Gradients gradients(const LoadedLevel& level, const cv::Mat& strip);

/// Faces that keyframes show whole, and how many of them are found again where they were, of at least two
/// thirds of their height.
struct FaceCount {
    int whole = 0;
    int found = 0;
};

/// The same for the regions of shots that leave room beside them. Here found means: of the region's patches
/// at least .95 are seen again near its place.
FaceCount count_subjects(const LoadedLevel& level, const cv::Mat& strip);

/// The subjects that somebody has marked in one frame of a film.
struct MarkedFrame {
    int number = 0;          // of the film's frames
    std::vector<Box> boxes;  // shares of the upright picture
};

/// The marked frames of a film. @param marks  boxes.json of the media with ground truth
std::vector<MarkedFrame> marked_frames(const std::filesystem::path& marks, const std::string& film);

/// The frames that may become keyframes and are nearest to the marked ones: their tapestry shows what is
/// marked. @param source  the film, from its begin
Keyframes keyframes_at(const Film& film, const std::vector<MarkedFrame>& marked, FrameSource& source);

/// Counts the subjects that are marked in a level's keyframes, and those that the strip shows like the
/// regions of count_subjects().
/// @param marked  one for each keyframe
FaceCount count_marked(const Film& film, const LoadedLevel& level, const std::vector<MarkedFrame>& marked,
                       const cv::Mat& strip);

FaceCount count_faces(const LoadedLevel& level, const cv::Mat& strip, FaceDetector& detector);

}  // namespace vitrine::analyzer
