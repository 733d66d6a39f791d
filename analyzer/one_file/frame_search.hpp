#pragma once

#include "analyzer/faces/face_detector.hpp"
#include "analyzer/film/film_frame.hpp"
#include "analyzer/one_file/subject_network.hpp"
#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/image_saliency.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/words/line_detector.hpp"
#include "base/state/record.hpp"

#include <chrono>
#include <memory>
#include <vector>

namespace vitrine::analyzer {

/// Searches single frames. Faces and lines of text are searched now and then, and hold until the next search.
class FrameSearch {
  public:
    /// A photo is shown to the network where the settings want it; its lines are searched then, too. Of a
    /// film what the network needs is kept in the samples. Logs a student that cannot be used, and does
    /// without it.
    /// @throws std::runtime_error if another model cannot be read
    FrameSearch(const AnalysisSettings& settings, MediaKind kind);

    /// Small faces are searched in the finer picture of a frame.
    /// @param pair   the frame's picture and the one before
    /// @param count  of the frames searched before
    /// @return       a sample without its look, its share of change, its picture and the time of the frame
    /// before
    Sample search(const FramePair& pair, const FilmFrame& frame, int count);

  private:
    void open_network();
    SaliencyMap subject_of(const FramePair& pair);

    const AnalysisSettings& settings_;     // outlives the search
    std::unique_ptr<FaceDetector> faces_;  // null: not searched
    std::unique_ptr<ImageSaliencyStage> stage_;
    std::unique_ptr<SubjectNetwork> network_;  // null: not asked
    std::unique_ptr<LineDetector> lines_;      // null: not searched
    bool keeps_glances_ = false;               // for looks at films
    std::vector<Face> last_faces_;
    std::chrono::nanoseconds faces_time_{0};
    std::vector<Box> last_lines_;
    std::chrono::nanoseconds lines_time_{0};
};

}  // namespace vitrine::analyzer
