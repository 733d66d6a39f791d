#include "analyzer/one_file/frame_search.hpp"

#include "analyzer/saliency/faces.hpp"
#include "base/system/log.hpp"

#include <stdexcept>

namespace vitrine::analyzer {

FrameSearch::FrameSearch(const AnalysisSettings& settings, MediaKind kind)
    : settings_(settings),
      faces_(face_detector(settings.face_model, settings.face_cascade)),
      stage_(image_saliency_stage(settings.image)) {
    const bool is_film = kind == MediaKind::film;
    if (!is_film) open_network();
    keeps_glances_ = is_film && !settings.saliency_model.empty();
    if ((is_film || network_) && !settings.text_model.empty())
        lines_ = std::make_unique<LineDetector>(settings.text_model);
}

/// A photo that the large network is to look at has its plain region already. One that the student looks at
/// has none yet, and must not be without one for the model's sake.
void FrameSearch::open_network() {
    try {
        network_ = photo_network(settings_);
    } catch (const std::runtime_error& error) {
        if (!settings_.is_student) throw;
        log::warning("photos keep their plain regions: {}", error.what());
    }
}

SaliencyMap FrameSearch::subject_of(const FramePair& pair) {
    try {
        return network_->find(pair);
    } catch (const std::runtime_error& error) {
        if (!settings_.is_student) throw;
        log::warning("photos keep their plain regions: {}", error.what());
        network_.reset();
        return {};
    }
}

Sample FrameSearch::search(const FramePair& pair, const FilmFrame& frame, int count) {
    if (faces_ && count % settings_.face_interval == 0) {
        last_faces_ = find_faces(*faces_, frame.picture, settings_.only_prominent_faces);
        if (frame.finer) add_small_faces(last_faces_, *faces_, frame.finer(), settings_.only_prominent_faces);
        faces_time_ = frame.time;
    }
    if (lines_ && count % settings_.text_interval == 0) {
        last_lines_ = find_lines(*lines_, pair);
        lines_time_ = frame.time;
    }
    Sample sample = sample_of(pair, settings_, last_faces_, stage_.get());
    if (network_) sample.subject = subject_of(pair);
    if (keeps_glances_) keep_glance(sample, pair);
    sample.time = frame.time;
    sample.faces = last_faces_;
    sample.faces_time = faces_time_;
    sample.lines = last_lines_;
    sample.lines_time = lines_time_;
    return sample;
}

}  // namespace vitrine::analyzer
