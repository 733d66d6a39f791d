#include "analyzer/saliency/shot_region.hpp"

#include "analyzer/saliency/motion_contrast.hpp"
#include "analyzer/saliency/movers.hpp"
#include "analyzer/words/steady_lines.hpp"
#include "analyzer/words/text_page.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {
namespace {

// Added at the centre, per sample: decides where nothing stands out.
constexpr double centre_saliency = 0.005;
constexpr double min_motion = 0.002;     // share of the picture that moves on average, to count
constexpr double enough_motion = 1.25;   // certainty for each share of it that is held
constexpr double followed_motion = 0.9;  // share of what moves that a drift must keep in the common part
constexpr double min_face = 0.05;        // share of the map's longer side: smaller faces do not count

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// Drops motion measured across the shot's begin, and replaces faces and lines found before it by the next
/// found in it.
void drop_shot_before(std::vector<Sample>& samples, std::chrono::nanoseconds begin) {
    for (std::size_t i = samples.size(); i-- > 0;) {
        Sample& sample = samples[i];
        if (sample.lines_time < begin) {
            const bool is_last = i + 1 == samples.size();
            sample.lines = is_last ? std::vector<Box>{} : samples[i + 1].lines;
            sample.lines_time = is_last ? begin : samples[i + 1].lines_time;
        }
        if (sample.pair_time < begin) {
            sample.motion.release();
            sample.global_motion = {};
            sample.subject_motion = {};
        }
        if (sample.faces_time >= begin) continue;
        sample.faces.clear();
        if (i + 1 < samples.size()) {
            sample.faces = samples[i + 1].faces;
            sample.faces_time = samples[i + 1].faces_time;
        }
    }
}

bool has_face_at(std::span<const Face> faces, const Box& box) {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const Face& face) { return overlap(face.box, box) >= same_face; });
}

/// One sample of each search for faces.
std::vector<const Sample*> searches(const std::vector<Sample>& samples) {
    std::vector<const Sample*> result;
    for (const Sample& sample : samples) {
        if (result.empty() || result.back()->faces_time != sample.faces_time) result.push_back(&sample);
    }
    return result;
}

/// The heads that must stay whole, moved to their places at the shot's begin: heads of faces that are large
/// enough and, in a film, seen at nearly the same place in two searches, for a detector errs now and then.
std::vector<Box> heads(const std::vector<Sample>& samples, std::chrono::nanoseconds begin, Vec2 drift,
                       cv::Size map) {
    std::vector<Box> result;
    const std::vector<const Sample*> found = searches(samples);
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const Face& face : found[i]->faces) {
            if (face.box.height() < min_face * std::max(map.width, map.height)) continue;
            const bool is_seen_before = i > 0 && has_face_at(found[i - 1]->faces, face.box);
            const bool is_seen_after = i + 1 < found.size() && has_face_at(found[i + 1]->faces, face.box);
            if (found.size() > 1 && !is_seen_before && !is_seen_after) continue;
            result.push_back(moved(head_of(face), drift * -seconds(found[i]->faces_time - begin)));
        }
    }
    return result;
}

/// The lines of each search in the shot.
std::vector<LineSearch> line_searches(const std::vector<Sample>& samples, std::chrono::nanoseconds begin) {
    std::vector<LineSearch> found;
    const Sample* last = nullptr;
    for (const Sample& sample : samples) {
        if (last == nullptr || last->lines_time != sample.lines_time)
            found.push_back({.time = seconds(sample.lines_time - begin), .lines = sample.lines});
        last = &sample;
    }
    return found;
}

std::vector<SalientFrame> salient_frames(const std::vector<Sample>& samples, std::chrono::nanoseconds begin,
                                         const AnalysisSettings& settings) {
    std::vector<SalientFrame> frames;
    for (const Sample& sample : samples) {
        const SaliencyMap face = face_saliency(sample.faces, sample.image.size(), 1, settings.has_bodies);
        frames.push_back({.map = combined(sample.motion, sample.image, face, settings.weights),
                          .time = seconds(sample.time - begin),
                          .global_motion = sample.global_motion,
                          .subject_motion = sample.subject_motion,
                          .subject = sample.subject});
    }
    return frames;
}

/// All that must stay whole: heads, movers, lines of text, and the words of a title.
/// @param searches  of the samples, for lines of text
std::vector<Box> whole_parts(const std::vector<Sample>& samples, std::span<const LineSearch> searches,
                             const Shot& shot, Vec2 drift, cv::Size map) {
    std::vector<Box> result = heads(samples, shot.begin, drift, map);
    for (const Box& mover : movers(samples, shot.begin, drift))
        result.push_back(mover);
    for (const Box& line : steady_lines(searches, drift))
        result.push_back(line);
    for (const Sample& sample : samples) {
        if (!shot.is_title || sample.look.kind != PictureKind::title) continue;
        const cv::Rect words = sample.look.stands_out & cv::Rect({0, 0}, map);
        if (words.empty()) continue;
        result.push_back({{static_cast<double>(words.x), static_cast<double>(words.y)},
                          {static_cast<double>(words.br().x), static_cast<double>(words.br().y)}});
    }
    return result;
}

/// A region in px of the map becomes one in px of the source.
IRegion to_source(const Polygon& polygon, Vec2 drift, cv::Size map, cv::Size source) {
    const Vec2 scale{static_cast<double>(source.width) / map.width,
                     static_cast<double>(source.height) / map.height};
    IRegion region{.polygon = polygon, .drift = {drift.x * scale.x, drift.y * scale.y}};
    for (Vec2& p : region.polygon)
        p = {p.x * scale.x, p.y * scale.y};
    return region;
}

/// The shot's picture within its bars, in px of the map.
cv::Rect active_part(const Shot& shot, cv::Size map, cv::Size source) {
    const cv::Rect whole({0, 0}, map);
    if (!shot.picture) return whole;
    const double x = static_cast<double>(map.width) / source.width;
    const double y = static_cast<double>(map.height) / source.height;
    const Box& picture = *shot.picture;
    const cv::Rect part(cv::Point(cvRound(picture.min.x * x), cvRound(picture.min.y * y)),
                        cv::Point(cvRound(picture.max.x * x), cvRound(picture.max.y * y)));
    return (part & whole).empty() ? whole : part & whole;
}

void move_faces(std::vector<Face>& faces, Vec2 by) {
    for (Face& face : faces)
        face.box = moved(face.box, by);
}

void move_lines(std::vector<Box>& lines, Vec2 by) {
    for (Box& line : lines)
        line = moved(line, by);
}

/// Leaves only a part of each sample's maps; the faces move along.
void crop(std::vector<Sample>& samples, const cv::Rect& part) {
    const Vec2 corner{static_cast<double>(part.x), static_cast<double>(part.y)};
    for (Sample& sample : samples) {
        for (SaliencyMap* map : {&sample.motion, &sample.image, &sample.subject})
            if (!map->empty()) *map = SaliencyMap((*map)(part).clone());
        move_faces(sample.faces, corner * -1);
        move_lines(sample.lines, corner * -1);
        sample.look.stands_out -= part.tl();
    }
}

/// Puts the maps and faces of a part back into their places in the whole map.
void place(ShotEvidence& evidence, const cv::Rect& part, cv::Size size) {
    for (SaliencyMap* map : {&evidence.motion, &evidence.image, &evidence.face, &evidence.combined,
                             &evidence.volume, &evidence.subject}) {
        if (map->empty()) continue;
        SaliencyMap whole = SaliencyMap::zeros(size, CV_32FC1);
        map->copyTo(whole(part));
        *map = whole;
    }
    const Vec2 corner{static_cast<double>(part.x), static_cast<double>(part.y)};
    move_faces(evidence.faces, corner);
    for (ShownFrame& frame : evidence.frames) {
        move_faces(frame.faces, corner);
        move_lines(frame.lines, corner);
    }
}

void add_centre(SaliencyMap& volume, std::size_t frames) {
    volume += centre_prior(volume.size()) *
              (centre_saliency * static_cast<double>(std::max<std::size_t>(1, frames)));
}

/// The page of text that a photo shows; no corners where it shows none, where somebody is before it, and in a
/// film.
Polygon page_in(const std::vector<Sample>& samples, cv::Size size) {
    if (samples.size() != 1 || !samples.front().faces.empty()) return {};
    return text_page(samples.front().lines,
                     {static_cast<double>(size.width), static_cast<double>(size.height)});
}

/// The share of a shot's strong motion that a polygon holds, px of the shot's begin; 1 where next to nothing
/// moves.
double held_motion(const std::vector<Sample>& samples, const std::vector<SalientFrame>& frames, Vec2 drift,
                   const Polygon& polygon) {
    std::vector<SalientFrame> moving;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].motion.empty()) continue;
        SaliencyMap strong;
        cv::threshold(samples[i].motion, strong, strong_motion, 1, cv::THRESH_BINARY);
        moving.push_back({.map = strong, .time = frames[i].time, .global_motion = {}, .subject_motion = {}});
    }
    if (moving.empty()) return 1;
    const SaliencyMap volume = accumulated(moving, drift);
    double all = 0;
    for (const SalientFrame& frame : moving)
        all += cv::sum(frame.map)[0];
    if (all < min_motion * static_cast<double>(volume.total() * moving.size())) return 1;
    std::vector<cv::Point> corners;
    for (const Vec2 corner : polygon)
        corners.emplace_back(cvRound(corner.x), cvRound(corner.y));
    SaliencyMap inside = SaliencyMap::zeros(volume.size(), CV_32FC1);
    if (corners.size() >= 3) cv::fillConvexPoly(inside, corners, 1);
    return volume.dot(inside) / all;
}

/// The outline of all places of the subject. It is as certain as the looks were on average, and no more
/// certain than the share of what moves that it holds.
SubjectOutline seen_outline(const std::vector<Sample>& samples, const std::vector<SalientFrame>& frames,
                            Vec2 drift, const SaliencyMap& subject) {
    SubjectOutline outline = subject_outline(subject);
    if (samples.size() == 1) return outline;
    double sum = 0;
    int looks = 0;
    for (const Sample& sample : samples) {
        if (sample.subject.empty()) continue;
        sum += subject_outline(sample.subject).certainty;
        ++looks;
    }
    const double moving = held_motion(samples, frames, drift, outline.possible);
    outline.certainty = std::min(sum / looks, enough_motion * moving);
    outline.certainty = std::clamp(outline.certainty, 0.0, 1.0);
    return outline;
}

/// The drift, or none where it leaves behind what moves: something that crosses the picture, or overtakes the
/// camera, faster than a region can follow.
Vec2 following_drift(const std::vector<Sample>& samples, const std::vector<SalientFrame>& frames, Vec2 drift,
                     const Box& core) {
    return held_motion(samples, frames, drift, to_polygon(core)) < followed_motion ? Vec2{} : drift;
}

void show_middle(ShotEvidence& evidence, const std::vector<Sample>& samples,
                 const std::vector<SalientFrame>& frames, bool has_bodies) {
    const std::size_t middle = samples.size() / 2;
    const Sample& sample = samples[middle];
    for (const Sample* shown : {&samples.front(), &sample, &samples.back()}) {
        if (!shown->picture.empty())
            evidence.frames.push_back({shown->picture, shown->time, shown->faces, shown->lines});
    }
    evidence.motion = sample.motion;
    evidence.image = sample.image;
    evidence.faces = sample.faces;
    evidence.face = face_saliency(sample.faces, sample.image.size(), 1, has_bodies);
    evidence.combined = frames[middle].map;
}

}  // namespace

ShotEvidence shot_region(std::vector<Sample> samples, Shot shot, cv::Size map, cv::Size source,
                         const AnalysisSettings& settings) {
    drop_shot_before(samples, shot.begin);
    const cv::Rect part = active_part(shot, map, source);
    if (part.size() != map) crop(samples, part);
    const std::vector<SalientFrame> frames = salient_frames(samples, shot.begin, settings);
    const double duration = seconds(shot.duration());
    Vec2 drift = shot.is_title ? Vec2{} : found_drift(frames, duration, settings.drift);
    const std::vector<LineSearch> searches = line_searches(samples, shot.begin);
    if (has_caption(searches, drift)) drift = {};  // which stands still
    if (settings.drift == DriftMode::smallest_area)
        drift = following_drift(samples, frames, drift, common_part(part.size(), drift, duration));
    ShotEvidence evidence{.samples = samples.size()};
    evidence.volume =
        frames.empty() ? SaliencyMap(SaliencyMap::zeros(part.size(), CV_32FC1)) : accumulated(frames, drift);
    SaliencyMap volume = evidence.volume.clone();
    if (settings.region.mode == RegionMode::min_area) add_centre(volume, frames.size());
    const std::vector<Box> whole = whole_parts(samples, searches, shot, drift, part.size());
    const Box core = common_part(part.size(), drift, duration);
    Polygon region = i_region(volume, core, whole, settings.region);
    evidence.subject = subject_volume(frames, drift);
    if (!evidence.subject.empty()) {
        const Polygon page = page_in(samples, part.size());
        evidence.is_page = !page.empty();
        const SubjectOutline subject = evidence.is_page
                                           ? SubjectOutline{.sure = page, .possible = page, .certainty = 1}
                                           : seen_outline(samples, frames, drift, evidence.subject);
        region = subject_region(subject, volume, core, whole, settings.region);
        shot.certainty = subject.certainty;
    }
    for (Vec2& corner : region)
        corner = corner + Vec2{static_cast<double>(part.x), static_cast<double>(part.y)};
    shot.region = to_source(region, drift, map, source);
    if (shot.picture) shot.region.polygon = clipped(shot.region.polygon, *shot.picture);
    if (!samples.empty()) shot.look = samples[samples.size() / 2].signature;
    evidence.shot = std::move(shot);
    if (!samples.empty()) show_middle(evidence, samples, frames, settings.has_bodies);
    if (part.size() != map) place(evidence, part, map);
    return evidence;
}

}  // namespace vitrine::analyzer
