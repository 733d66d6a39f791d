#include "analyzer/saliency/sample.hpp"

#include "analyzer/saliency/background_motion.hpp"
#include "analyzer/words/text_page.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr int line_side = 640;           // px of the picture in which lines of text are searched
constexpr int small_line_side = 320;     // px of the small look for them
constexpr double line_trace = 1e-3;      // of the small look's map: there may be a line
constexpr double tall_line = 0.07;       // of the picture's longest side
constexpr double max_small_face = 0.12;  // share of the map's longer side; larger ones are found in any frame

cv::Size fitted(cv::Size size, int side) {
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(size.width, size.height));
    return {std::max(1, static_cast<int>(std::lround(size.width * scale))),
            std::max(1, static_cast<int>(std::lround(size.height * scale)))};
}

cv::Mat resized(const cv::Mat& picture, cv::Size size) {
    if (picture.size() == size) return picture;
    cv::Mat result;
    cv::resize(picture, result, size, 0, 0, cv::INTER_AREA);
    return result;
}

cv::Mat grey(const cv::Mat& bgr) {
    cv::Mat result;
    cv::cvtColor(bgr, result, cv::COLOR_BGR2GRAY);
    return result;
}

/// The motion that most of the salient part agrees on.
Vec2 motion_of_salient(const FlowField& flow, const SaliencyMap& saliency) {
    if (flow.vectors.empty()) return {};  // the picture is too narrow for any
    cv::Mat by_cell;
    cv::resize(saliency, by_cell, flow.grid, 0, 0, cv::INTER_AREA);
    const double mean = cv::mean(by_cell)[0];
    std::vector<Vec2> vectors;
    std::vector<double> weights;
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        const double weight = static_cast<double>(by_cell.ptr<float>()[i]) - mean;
        if (!flow.is_reliable[i] || weight <= 0) continue;
        vectors.push_back(flow.vectors[i]);
        weights.push_back(weight);
    }
    return voted_motion(vectors, weights);
}

std::vector<Face> scaled(std::span<const Face> faces, double scale) {
    std::vector<Face> result(faces.begin(), faces.end());
    for (Face& face : result)
        face.box = {face.box.min * scale, face.box.max * scale};
    return result;
}

/// The signature by which shots are compared.
ShotLook signature_of(const cv::Mat& bgr) {
    ShotLook look;
    const cv::Mat shades = resized(grey(bgr), {ShotLook::hash_side + 1, ShotLook::hash_side});
    for (int y = 0; y < ShotLook::hash_side; ++y)
        for (int x = 0; x < ShotLook::hash_side; ++x)
            look.hash = look.hash << 1U | static_cast<unsigned>(shades.at<std::uint8_t>(y, x) >
                                                                shades.at<std::uint8_t>(y, x + 1));
    const cv::Mat fields = resized(bgr, {ShotLook::grid, ShotLook::grid});
    std::size_t i = 0;
    for (int y = 0; y < ShotLook::grid; ++y)
        for (int x = 0; x < ShotLook::grid; ++x)
            for (const int channel : {2, 1, 0})
                look.colours[i++] = fields.at<cv::Vec3b>(y, x)[channel];
    return look;
}

/// Searches a frame without bars.
Sample searched(const FramePair& pair, const AnalysisSettings& settings, std::span<const Face> faces,
                ImageSaliencyStage* stage) {
    const auto& [frame, before, seconds, active] = pair;
    const cv::Size size = fitted(frame.size(), settings.frame_size);
    const cv::Size map = map_size(frame.size());
    const cv::Mat now = resized(frame, size);
    Sample sample;
    sample.signature = signature_of(now);
    const std::vector<Face> placed = scaled(faces, static_cast<double>(size.width) / map.width);
    const std::unique_ptr<ImageSaliencyStage> own =
        stage == nullptr ? image_saliency_stage(settings.image) : nullptr;
    sample.image = resized((stage == nullptr ? *own : *stage).map(now, placed), map);
    if (before.size() == frame.size()) {
        const cv::Size seen = settings.motion == MotionMethod::voted_pan ? size : map;
        const MotionContrast motion =
            motion_contrast(resized(grey(before), seen), resized(grey(frame), seen), settings.motion);
        sample.motion = resized(motion.map, map);
        const double speed = map.width / (seen.width * seconds);
        sample.global_motion = motion.global_motion * speed;
        if (settings.drift == DriftMode::smallest_area) {
            const SaliencyMap both = combined(sample.motion, sample.image, {}, settings.weights);
            sample.subject_motion = motion_of_salient(motion.flow, both) * speed;
        }
    }
    return sample;
}

/// The part of a frame within its bars; all of it where none is known.
cv::Rect seen_part(const cv::Rect& active, cv::Size frame) {
    const cv::Rect whole({0, 0}, frame);
    return (active & whole).empty() ? whole : active & whole;
}

/// The map of a part of a frame becomes one of the frame, with 0 around it.
SaliencyMap placed_map(const SaliencyMap& map, const cv::Rect& part, cv::Size size) {
    if (map.empty()) return map;
    SaliencyMap result = SaliencyMap::zeros(size, CV_32FC1);
    resized(map, part.size()).copyTo(result(part));
    return result;
}

double largest_value(const cv::Mat& map) {
    double largest = 0;
    cv::minMaxLoc(map, nullptr, &largest);
    return largest;
}

/// Says if a small look sees a line's core within a line.
/// @param line     px of the picture
/// @param map      what the look sees of all of the picture
bool is_seen(const Box& line, const cv::Mat& map, cv::Size picture) {
    const double x = static_cast<double>(map.cols) / picture.width;
    const double y = static_cast<double>(map.rows) / picture.height;
    const cv::Point corner{static_cast<int>(line.min.x * x), static_cast<int>(line.min.y * y)};
    const cv::Point end{static_cast<int>(std::ceil(line.max.x * x)),
                        static_cast<int>(std::ceil(line.max.y * y))};
    const cv::Rect part = cv::Rect(corner, end) & cv::Rect({}, map.size());
    return !part.empty() && largest_value(map(part)) >= line_core;
}

/// Says if a box is no longer than one letter.
bool is_one_letter(const Box& line) {
    return std::max(line.width(), line.height()) < 1.5 * std::min(line.width(), line.height());
}

/// The lines in a picture, px of it, as far as a reader would miss them. A small look comes first where the
/// picture is no larger: there are no lines where it sees no trace of one. A tall line has several letters,
/// and both looks see it: enlarged, a car or a dog's head may be taken for a letter.
std::vector<Box> lines_in(LineDetector& detector, const cv::Mat& picture) {
    const int longest = std::max(picture.cols, picture.rows);
    cv::Mat small;
    if (longest <= small_line_side) {
        small = detector.map(picture, small_line_side);
        if (largest_value(small) < line_trace) return {};
    }
    const Vec2 size{static_cast<double>(picture.cols), static_cast<double>(picture.rows)};
    std::vector<Box> lines = readable_lines(detector.find(picture, line_side), size);
    std::erase_if(lines, [&](const Box& line) {
        if (line.height() <= tall_line * longest) return false;
        if (is_one_letter(line)) return true;
        if (small.empty()) small = detector.map(picture, small_line_side);
        return !is_seen(line, small, picture.size());
    });
    return lines;
}

}  // namespace

cv::Size map_size(cv::Size frame) {
    return fitted(frame, map_side);
}

cv::Rect map_part(const cv::Rect& part, cv::Size frame) {
    const cv::Size map = map_size(frame);
    const double scale_x = static_cast<double>(map.width) / frame.width;
    const double scale_y = static_cast<double>(map.height) / frame.height;
    const int left = std::min(map.width - 1, cvRound(part.x * scale_x));
    const int top = std::min(map.height - 1, cvRound(part.y * scale_y));
    const int right = std::clamp(cvRound(part.br().x * scale_x), left + 1, map.width);
    const int bottom = std::clamp(cvRound(part.br().y * scale_y), top + 1, map.height);
    return {left, top, right - left, bottom - top};
}

Sample sample_of(const FramePair& pair, const AnalysisSettings& settings, std::span<const Face> faces,
                 ImageSaliencyStage* stage) {
    const cv::Rect active = pair.active & cv::Rect({0, 0}, pair.frame.size());
    if (active.empty() || active.size() == pair.frame.size()) return searched(pair, settings, faces, stage);
    const cv::Rect part = map_part(active, pair.frame.size());
    FramePair inner{.frame = pair.frame(active).clone(), .before = {}, .seconds = pair.seconds, .active = {}};
    if (pair.before.size() == pair.frame.size()) inner.before = pair.before(active).clone();
    const double scale = static_cast<double>(map_size(active.size()).width) / part.width;
    const Vec2 corner{static_cast<double>(part.x), static_cast<double>(part.y)};
    std::vector<Face> moved_faces(faces.begin(), faces.end());
    for (Face& face : moved_faces)
        face.box = {(face.box.min - corner) * scale, (face.box.max - corner) * scale};
    Sample sample = searched(inner, settings, moved_faces, stage);
    const cv::Size map = map_size(pair.frame.size());
    sample.motion = placed_map(sample.motion, part, map);
    sample.image = placed_map(sample.image, part, map);
    sample.global_motion = sample.global_motion * (1 / scale);
    sample.subject_motion = sample.subject_motion * (1 / scale);
    return sample;
}

PictureLook look_within(const cv::Mat& frame, const cv::Rect& active) {
    const cv::Rect seen = seen_part(active, frame.size());
    const cv::Rect part = map_part(seen, frame.size());
    PictureLook look = look_at(frame(seen), part.size());
    look.stands_out += part.tl();
    return look;
}

SaliencyMap find_subject(SaliencyNetwork& network, const FramePair& pair) {
    const cv::Size size = pair.frame.size();
    const cv::Rect active = seen_part(pair.active, size);
    return placed_map(network.map(pair.frame(active)), map_part(active, size), map_size(size));
}

void keep_glance(Sample& sample, const FramePair& pair) {
    const cv::Rect active = seen_part(pair.active, pair.frame.size());
    sample.glance = resized(pair.frame(active), look_size(active.size(), coarse_side)).clone();
    sample.seen = map_part(active, pair.frame.size());
}

SaliencyMap subject_in(SaliencyNetwork& network, const Sample& sample) {
    return placed_map(network.map(sample.glance), sample.seen, sample.image.size());
}

std::vector<Box> find_lines(LineDetector& detector, const FramePair& pair) {
    const cv::Size size = pair.frame.size();
    const cv::Rect active = seen_part(pair.active, size);
    const double scale = static_cast<double>(map_size(size).width) / size.width;
    const Vec2 corner{static_cast<double>(active.x), static_cast<double>(active.y)};
    std::vector<Box> lines = lines_in(detector, pair.frame(active));
    for (Box& line : lines)
        line = {(line.min + corner) * scale, (line.max + corner) * scale};
    return lines;
}

std::vector<Face> find_faces(FaceDetector& detector, const cv::Mat& frame, bool only_prominent) {
    const double scale = static_cast<double>(map_size(frame.size()).width) / frame.cols;
    std::vector<Face> faces = detector.detect(frame);
    if (only_prominent) faces = prominent(std::move(faces));
    return scaled(faces, scale);
}

void add_small_faces(std::vector<Face>& faces, FaceDetector& detector, const cv::Mat& finer,
                     bool only_prominent) {
    for (const Face& face : find_faces(detector, finer, false)) {
        const bool is_known = std::ranges::any_of(
            faces, [&](const Face& other) { return overlap(face.box, other.box) >= same_face; });
        if (!is_known && face.box.height() <= max_small_face * map_side) faces.push_back(face);
    }
    if (only_prominent) faces = prominent(std::move(faces));
}

}  // namespace vitrine::analyzer
