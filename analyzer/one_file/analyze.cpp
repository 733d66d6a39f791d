#include "analyzer/one_file/analyze.hpp"

#include "analyzer/film/active_picture.hpp"
#include "analyzer/film/shot_detector.hpp"
#include "analyzer/one_file/between_shots.hpp"
#include "analyzer/one_file/frame_search.hpp"
#include "analyzer/one_file/picture_print.hpp"
#include "analyzer/one_file/subject_looks.hpp"
#include "analyzer/saliency/sample_store.hpp"
#include "analyzer/saliency/take_parts.hpp"
#include "base/state/media_error.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vitrine::analyzer {
namespace {

using std::chrono::nanoseconds;

constexpr std::size_t max_shots = 10'000;           // in a file; later ones are not shown
constexpr nanoseconds usual_interval{40'000'000};   // the duration of the last frame, if it is not known
constexpr nanoseconds max_interval{1'000'000'000};  // between two frames that are compared for motion

/// Turns frames into samples, a few a second.
class Sampler {
  public:
    Sampler(const AnalysisSettings& settings, bool keeps_pictures, MediaKind kind)
        : settings_(settings),
          keeps_pictures_(keeps_pictures),
          is_film_(kind == MediaKind::film),
          search_(settings, kind) {}

    /// @param frame  later than the last; a sample is taken where the last is at least an interval old
    void push(const FilmFrame& frame, SampleStore& into) {
        if (count_ == 0 || frame.time >= due_) {
            bars_.add_picture(frame.picture, frame.time);
            into.push(sample(frame));
            due_ = frame.time + nanoseconds(std::chrono::seconds(1)) / settings_.samples_per_second;
        }
        before_ = frame;
        before_.finer = nullptr;  // it keeps the decoded frame
    }

    UnshownTimes& unshown() { return unshown_; }

    /// The bars of the samples so far.
    ActivePictureFinder& bars() { return bars_; }

  private:
    Sample sample(const FilmFrame& frame) {
        const nanoseconds interval = frame.time - before_.time;
        const bool has_pair = count_ > 0 && interval > nanoseconds(0) && interval <= max_interval;
        const FramePair pair{.frame = frame.picture,
                             .before = has_pair ? before_.picture : cv::Mat(),
                             .seconds = std::chrono::duration<double>(interval).count(),
                             .active = bars_.newest()};
        Sample sample = search_.search(pair, frame, count_);
        if (is_film_) sample.look = look_within(frame.picture, pair.active);
        if (!sampled_.empty()) sample.changed_share = changed_share(sampled_, frame.picture);
        sampled_ = frame.picture;
        unshown_.add_sample(frame.time, sample.look.kind == PictureKind::plain);
        ++count_;
        sample.pair_time = before_.time;
        if (keeps_pictures_) sample.picture = frame.picture;
        return sample;
    }

    const AnalysisSettings& settings_;  // outlives the sampler
    bool keeps_pictures_;
    bool is_film_;
    FrameSearch search_;
    ActivePictureFinder bars_;
    UnshownTimes unshown_;
    cv::Mat sampled_;  // the picture of the last sample
    FilmFrame before_;
    nanoseconds due_{0};
    int count_ = 0;
};

/// A part of the frames in px of the source; none where it is all of it.
std::optional<Box> to_source(const cv::Rect& part, cv::Size frame, const MediaRecord& record) {
    if (part.size() == frame) return std::nullopt;
    const double x = static_cast<double>(record.width) / frame.width;
    const double y = static_cast<double>(record.height) / frame.height;
    return Box{{part.x * x, part.y * y}, {part.br().x * x, part.br().y * y}};
}

/// The faces and lines of text in a photo's only sample, px of the source.
std::vector<Box> marks_of(const std::vector<Sample>& samples, cv::Size frame, const MediaRecord& record) {
    std::vector<Box> marks;
    if (record.kind != MediaKind::photo || samples.empty()) return marks;
    const cv::Size map = map_size(frame);
    const double scale = static_cast<double>(record.width) / map.width;
    const auto add = [&](const Box& box) {
        if (marks.size() < Shot::max_marks) marks.push_back({box.min * scale, box.max * scale});
    };
    for (const Face& face : samples.front().faces)
        add(face.box);
    std::ranges::for_each(samples.front().lines, add);
    return marks;
}

/// The kind of a shot: plain where all its samples are, a title where no more than one in five is a picture.
PictureKind kind_of(const std::vector<Sample>& samples) {
    const auto count = [&](PictureKind kind) {
        return std::ranges::count(samples, kind, [](const Sample& sample) { return sample.look.kind; });
    };
    const auto all = std::ssize(samples);
    if (all > 0 && count(PictureKind::plain) == all) return PictureKind::plain;
    const bool is_title = count(PictureKind::title) > 0 && count(PictureKind::picture) * 5 <= all;
    return is_title ? PictureKind::title : PictureKind::picture;
}

/// Adds shots to the record: takes the samples of each, cuts off its bars and finds its region.
class ShotWriter {
  public:
    ShotWriter(MediaRecord& record, const AnalysisSettings& settings, const ShotObserver& observer,
               const GrowthObserver& grown)
        : record_(record),
          settings_(settings),
          observer_(observer),
          grown_(grown),
          told_(record),
          looks_(settings, record) {
        told_.is_complete = false;
    }

    SampleStore& samples() { return samples_; }

    /// Writes a take as one shot, or as several if it is long. A plain take is none.
    /// @param sampler  has its bars, and is told what is not shown
    void close(const DetectedShot& found, Sampler& sampler) {
        const nanoseconds end = std::max(found.end, found.begin + nanoseconds(1));
        std::vector<Sample> samples = samples_.pop_samples(found.begin, end);
        const PictureKind kind = kind_of(samples);
        if (kind == PictureKind::plain) return;
        const bool is_title = kind == PictureKind::title;
        auto first = samples.begin();
        const auto parts = is_title ? std::vector{TakePart{found.begin, found.end}}
                                    : take_parts(samples, found.begin, found.end);
        for (const TakePart& part : parts) {
            const auto last = std::find_if(first, samples.end(),
                                           [&](const Sample& sample) { return sample.time >= part.end; });
            std::vector<Sample> own(std::make_move_iterator(first),
                                    std::make_move_iterator(part.end == found.end ? samples.end() : last));
            first = last;
            const ShotEnd ends_with = part.end == found.end ? found.ends_with : ShotEnd::split;
            if (part.is_empty)
                sampler.unshown().add_empty(part.begin, part.end);
            else
                write({.begin = part.begin, .end = part.end, .ends_with = ends_with, .is_title = is_title},
                      std::move(own), sampler.bars());
        }
    }

    /// Cuts off the bars that only later shots made known.
    void finish(const ActivePictureFinder& bars) {
        const std::vector<cv::Rect> active = bars.all_shots();
        for (std::size_t i = 0; i < record_.shots.size(); ++i) {
            Shot& shot = record_.shots[i];
            const std::optional<Box> picture = to_source(active[i], bars.whole().size(), record_);
            if (shot.picture || !picture) continue;
            shot.picture = picture;
            shot.region.polygon = clipped(shot.region.polygon, *picture);
        }
    }

  private:
    void write(Shot shot, std::vector<Sample> samples, ActivePictureFinder& bars) {
        const cv::Rect active = bars.close_shot(shot.begin, std::max(shot.end, shot.begin + nanoseconds(1)));
        if (record_.shots.size() >= max_shots) return;
        const cv::Size frame = bars.whole().size();
        shot.picture = to_source(active, frame, record_);
        shot.marks = marks_of(samples, frame, record_);
        looks_.look(shot, samples);
        const ShotEvidence evidence = shot_region(std::move(samples), shot, map_size(frame),
                                                  {record_.width, record_.height}, settings_);
        record_.shots.push_back(evidence.shot);
        if (observer_) observer_(evidence);
        if (!grown_ || record_.kind == MediaKind::photo) return;
        told_.shots = {evidence.shot};
        grown_(told_);
    }

    MediaRecord& record_;  // all four outlive the writer
    const AnalysisSettings& settings_;
    const ShotObserver& observer_;
    const GrowthObserver& grown_;
    MediaRecord told_;  // the record that `grown` gets, with the newest shot
    SampleStore samples_;
    SubjectLooks looks_;
};

/// The picture within its bars.
cv::Mat seen_part(const FilmFrame& frame, const ActivePictureFinder& bars) {
    const cv::Rect part = bars.newest() & cv::Rect({0, 0}, frame.picture.size());
    return part.empty() ? frame.picture : frame.picture(part);
}

void close_photo(ShotWriter& writer, Sampler& sampler, const FilmFrame& photo, MediaRecord& record) {
    writer.close({}, sampler);
    if (!record.shots.empty()) record.shots.front().print = print_of(seen_part(photo, sampler.bars()));
}

nanoseconds film_end(const MediaInfo& info, nanoseconds last, nanoseconds interval) {
    if (interval > nanoseconds(0)) return last + interval;
    return std::max(info.duration, last + usual_interval);
}

/// Reads the frames of a film after the first one, and writes its shots. @return  the film's duration
nanoseconds write_shots(FrameSource& source, const FilmFrame& first, Sampler& sampler, ShotWriter& writer) {
    ShotDetector detector;
    detector.push(first);
    nanoseconds interval{0};
    nanoseconds last_time = first.time;
    while (const std::optional<FilmFrame> frame = source.next()) {
        // Frames of a broken stream may repeat a time or change their size.
        if (frame->time <= last_time || frame->picture.size() != first.picture.size()) continue;
        for (const DetectedShot& shot : detector.push(*frame))
            writer.close(shot, sampler);
        sampler.push(*frame, writer.samples());
        interval = frame->time - last_time;
        last_time = frame->time;
    }
    const nanoseconds end = film_end(source.info(), last_time, interval);
    for (const DetectedShot& shot : detector.finish(end))
        writer.close(shot, sampler);
    return end;
}

}  // namespace

MediaRecord analyze(FrameSource& source, const AnalysisSettings& settings, const ShotObserver& observer,
                    const GrowthObserver& grown) {
    cv::setNumThreads(1);  // the decoder needs the other core; OpenCV's threads would mostly spin on it
    const MediaInfo& info = source.info();
    MediaRecord record{.kind = info.kind,
                       .state = MediaState::ready,
                       .width = info.width,
                       .height = info.height,
                       .duration = info.duration,
                       .origin = info.origin};
    std::optional<FilmFrame> frame = source.next();
    if (!frame) throw MediaError(MediaState::failed, "it holds no picture that can be decoded");
    Sampler sampler(settings, static_cast<bool>(observer), info.kind);
    ShotWriter writer(record, settings, observer, grown);
    sampler.push(*frame, writer.samples());
    if (info.kind == MediaKind::photo) {
        close_photo(writer, sampler, *frame, record);
        return record;
    }
    frame->finer = nullptr;  // it keeps the decoded frame
    record.duration = write_shots(source, *frame, sampler, writer);
    if (record.shots.empty()) writer.close({.begin = nanoseconds(0), .end = record.duration}, sampler);
    writer.finish(sampler.bars());
    record.between = sampler.unshown().between(record);
    return record;
}

}  // namespace vitrine::analyzer
