#include "bench/tapestry/measures.hpp"

#include "analyzer/one_file/analysed_file.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "analyzer/tapestry/synthesis/synthesis.hpp"
#include "analyzer/tapestry/weave/candidate_writer.hpp"

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <optional>

namespace vitrine::analyzer {

namespace {

constexpr double detector_scale = 2;  // pictures of 100 px are small for it

std::vector<cv::Rect> faces_in(const cv::Mat& picture, FaceDetector& detector) {
    cv::Mat large;
    cv::resize(picture, large, {}, detector_scale, detector_scale, cv::INTER_CUBIC);
    std::vector<cv::Rect> faces;
    for (const Face& face : detector.detect(large))
        faces.emplace_back(cv::Point(cv::Point2d(face.box.min.x, face.box.min.y) / detector_scale),
                           cv::Point(cv::Point2d(face.box.max.x, face.box.max.y) / detector_scale));
    return faces;
}

/// Searches overlapping pieces as wide as a tile; a face seen in two counts once.
std::vector<cv::Rect> faces_in_strip(const cv::Mat& strip, FaceDetector& detector) {
    constexpr int piece = 400;
    constexpr int step = 250;
    std::vector<cv::Rect> all;
    for (int x = 0; x == 0 || x + piece - step < strip.cols; x += step) {
        const cv::Rect part(x, 0, std::min(piece, strip.cols - x), strip.rows);
        for (const cv::Rect& face : faces_in(strip(part), detector)) {
            const cv::Rect placed = face + part.tl();
            const bool is_known = std::ranges::any_of(
                all, [&](const cv::Rect& other) { return (placed & other).area() * 3 > placed.area(); });
            if (!is_known) all.push_back(placed);
        }
    }
    return all;
}

double column_step(const cv::Mat& strip, int x, cv::Range rows) {
    if (x <= 0 || x >= strip.cols) return 0;
    const cv::Rect here(x, rows.start, 1, rows.size());
    const double norm = cv::norm(strip(here), strip(here - cv::Point(1, 0)), cv::NORM_L2);
    return norm * norm / rows.size() / 3;
}

double row_step(const cv::Mat& strip, int y) {
    const double norm = cv::norm(strip.row(y), strip.row(y - 1), cv::NORM_L2);
    return norm * norm / strip.cols / 3;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace

std::vector<Keyframe> LoadedLevel::bricks(const TileSpan& span) const {
    const cv::Range window = window_of(brickwork, span);
    std::vector<Keyframe> seen;
    for (int brick = brickwork.first_at(window.start); brick < brickwork.last_at(window.end); ++brick)
        seen.push_back(keyframes[static_cast<std::size_t>(std::min(brick, brickwork.keyframes - 1))]);
    return seen;
}

namespace {

/// Hands each frame on to a writer while it is analysed.
class KeepingSource : public FrameSource {
  public:
    KeepingSource(FrameSource& source, CandidateWriter& writer) : source_(source), writer_(writer) {}

    const MediaInfo& info() const override { return source_.info(); }

    std::optional<FilmFrame> next() override {
        std::optional<FilmFrame> frame = source_.next();
        if (frame) writer_.push(*frame);
        return frame;
    }

  private:
    FrameSource& source_;  // both outlive this
    CandidateWriter& writer_;
};

}  // namespace

Film analysed(FrameSource& source, FaceDetector* detector, int brick_height) {
    CandidateWriter writer(nameless_file(std::filesystem::temp_directory_path()), CandidateWriter::two_hours,
                           brick_height);
    KeepingSource keeping(source, writer);
    const MediaRecord record = analyze(keeping, analysis_settings(Settings{}.analyzer));
    return film_of(writer.finish(record, {}), detector);
}

LoadedLevel loaded(const Film& film, const Keyframes& keyframes) {
    LoadedLevel level{
        .brickwork = {.keyframes = static_cast<int>(keyframes.size()), .brick = film.candidates->brick()},
        .keyframes = {}};
    for (const int frame : keyframes)
        level.keyframes.push_back(film.candidates->keyframe(frame));
    return level;
}

cv::Mat bricks_picture(const LoadedLevel& level) {
    const TileSpan all{0, level.brickwork.width()};
    return brick_window({level.brickwork, level.bricks(all)}, all, 1).picture.bgr();
}

cv::Mat squeezed(const LoadedLevel& level) {
    cv::Mat squeezed;
    cv::resize(bricks_picture(level), squeezed, {level.brickwork.width(), tapestry_height(level.brickwork)},
               0, 0, cv::INTER_AREA);
    return squeezed;
}

cv::Mat filmstrip(const LoadedLevel& level) {
    const int height = tapestry_height(level.brickwork);
    const cv::Size frame(level.brickwork.brick.width * height / level.brickwork.brick.height, height);
    const int count = std::min(level.brickwork.keyframes, std::max(1, level.brickwork.width() / frame.width));
    cv::Mat strip(height, level.brickwork.width(), CV_8UC3, cv::Scalar::all(255));
    for (int i = 0; i < count; ++i) {
        cv::Mat picture;
        const auto& keyframe =
            level.keyframes[static_cast<std::size_t>((2 * i + 1) * level.brickwork.keyframes / (2 * count))];
        cv::resize(keyframe.picture, picture, frame, 0, 0, cv::INTER_CUBIC);
        const cv::Rect place(i * frame.width, 0, frame.width, height);
        picture(cv::Rect(0, 0, (place & cv::Rect({}, strip.size())).width, height))
            .copyTo(strip(place & cv::Rect({}, strip.size())));
    }
    return strip;
}

int pairs_alike(const LoadedLevel& level) {
    constexpr double alike = 20;
    int pairs = 0;
    for (std::size_t k = 1; k < level.keyframes.size(); ++k) {
        const cv::Mat& picture = level.keyframes[k].picture;
        const double norm = cv::norm(level.keyframes[k - 1].picture, picture, cv::NORM_L2);
        pairs += norm / std::sqrt(3.0 * static_cast<double>(picture.total())) < alike ? 1 : 0;
    }
    return pairs;
}

cv::Mat woven(const LoadedLevel& level, TileQuality quality, int region_weight) {
    cv::Mat strip;
    weave_level({.brickwork = level.brickwork,
                 .keyframe = [&](int k) { return level.keyframes[static_cast<std::size_t>(k)]; }},
                [&](const cv::Mat& columns, const WovenSoFar&) {
                    if (strip.empty())
                        strip = columns.clone();
                    else
                        cv::hconcat(strip, columns, strip);
                },
                {.quality = quality, .window = {.region_weight = region_weight}});
    return strip;
}

double distance(const LoadedLevel& level, const TileSpan& span, const cv::Mat& strip) {
    constexpr int rounds = 12;
    constexpr int radius = 64;
    BrickSection section{.brickwork = level.brickwork,
                         .bricks = level.bricks(span),
                         .first = level.brickwork.first_at(window_of(level.brickwork, span).start)};
    for (Keyframe& brick : section.bricks)
        brick.faces.clear();
    const BrickWindow window = brick_window(section, span, 1);
    const RunTasks run = run_in_order;
    Synthesis synthesis(window, strip.colRange(span.from, span.to), {}, run);
    synthesis.match_by_place();
    return synthesis.searched_energy(radius, rounds);
}

Gradients gradients(const LoadedLevel& level, const cv::Mat& strip) {
    const cv::Range whole(0, strip.rows);
    std::vector<double> inside;
    std::vector<double> tiles;
    std::vector<double> bricks;
    std::vector<double> rows;
    for (int x = 1; x < strip.cols; ++x)
        inside.push_back(column_step(strip, x, whole));
    const std::vector<TileSpan> spans = tile_spans(strip.cols, level.brickwork.brick.height);
    const int overlap = tile_overlap(level.brickwork.brick.height);
    for (std::size_t i = 1; i < spans.size(); ++i)
        for (const int x : {0, overlap / 2, overlap})
            tiles.push_back(column_step(strip, spans[i].from + x, whole));
    for (int k = 2; k < level.brickwork.bricks(); ++k) {
        const int top = k % 2 * strip.rows / 2;
        bricks.push_back(column_step(strip, level.brickwork.place(k).x, {top, top + strip.rows / 2}));
    }
    for (int y = 1; y < strip.rows; ++y)
        rows.push_back(row_step(strip, y));
    return {.inside = mean(inside),
            .tile_borders = mean(tiles),
            .brick_borders = mean(bricks),
            .row_inside = mean(rows),
            .row_border = row_step(strip, strip.rows / 2)};
}

namespace {

constexpr double whole_share = 0.95;  // of the patches, for something that is whole

/// The share of a region's patches that the strip shows again near its place.
/// @param region  px of keyframe k
double shown_share(const LoadedLevel& level, int k, const std::vector<cv::Point>& region,
                   const cv::Mat& strip) {
    constexpr int stride = 4;            // px
    constexpr double near_enough = 300;  // squared grey levels a channel value
    const Keyframe& keyframe = level.keyframes[static_cast<std::size_t>(k)];
    const cv::Size brick = level.brickwork.brick;
    const cv::Rect place =
        cv::Rect(level.brickwork.place(k).x - brick.width / 4, 0, brick.width * 3 / 2, strip.rows) &
        cv::Rect({}, strip.size());
    const cv::Rect box = cv::boundingRect(region) & cv::Rect({}, brick);
    int all = 0;
    int shown = 0;
    for (int y = box.y; y + patch_side <= box.br().y; y += stride) {
        for (int x = box.x; x + patch_side <= box.br().x; x += stride) {
            const cv::Point2f middle(static_cast<float>(x + patch_side / 2),
                                     static_cast<float>(y + patch_side / 2));
            if (cv::pointPolygonTest(region, middle, false) < 0) continue;
            cv::Mat distances;
            cv::matchTemplate(strip(place), keyframe.picture(cv::Rect(x, y, patch_side, patch_side)),
                              distances, cv::TM_SQDIFF);
            double least = 0;
            cv::minMaxLoc(distances, &least);
            ++all;
            shown += least <= near_enough * patch_values ? 1 : 0;
        }
    }
    return all > 0 ? static_cast<double>(shown) / all : 1;
}

}  // namespace

FaceCount count_subjects(const LoadedLevel& level, const cv::Mat& strip) {
    FaceCount count;
    for (int k = 0; k < level.brickwork.keyframes; ++k) {
        const std::vector<cv::Point>& region = level.keyframes[static_cast<std::size_t>(k)].region;
        if (region.size() < 3) continue;
        ++count.whole;
        count.found += shown_share(level, k, region, strip) >= whole_share ? 1 : 0;
    }
    return count;
}

std::vector<MarkedFrame> marked_frames(const std::filesystem::path& marks, const std::string& film) {
    std::vector<MarkedFrame> marked;
    std::ifstream file(marks);
    const nlohmann::json all = nlohmann::json::parse(file);
    for (const auto& [name, frames] : all.at("video_frames").items()) {
        if (!film.ends_with("/" + name)) continue;
        for (const auto& [number, boxes] : frames.items()) {
            if (boxes.empty()) continue;
            MarkedFrame& frame = marked.emplace_back(MarkedFrame{.number = std::stoi(number), .boxes = {}});
            for (const auto& box : boxes)
                frame.boxes.push_back({{box.at(0), box.at(1)}, {box.at(2), box.at(3)}});
        }
    }
    std::ranges::sort(marked, {}, &MarkedFrame::number);
    return marked;
}

Keyframes keyframes_at(const Film& film, const std::vector<MarkedFrame>& marked, FrameSource& source) {
    std::vector<std::chrono::nanoseconds> times;
    while (const std::optional<FilmFrame> frame = source.next())
        times.push_back(frame->time);
    Keyframes keyframes;
    const auto& signatures = film.candidates->signatures();
    for (const MarkedFrame& frame : marked) {
        const auto time = times.at(static_cast<std::size_t>(frame.number));
        const auto nearest = std::ranges::min_element(
            signatures, {}, [&](const FrameSignature& other) { return std::chrono::abs(other.time - time); });
        keyframes.push_back(static_cast<int>(nearest - signatures.begin()));
    }
    return keyframes;
}

FaceCount count_marked(const Film& film, const LoadedLevel& level, const std::vector<MarkedFrame>& marked,
                       const cv::Mat& strip) {
    const cv::Size frame = film.candidates->frame();
    const cv::Rect active = film.candidates->active();
    const auto place = [&](double x, double y) {
        return cv::Point(
            cvRound((x * frame.width - active.x) / active.width * level.brickwork.brick.width),
            cvRound((y * frame.height - active.y) / active.height * level.brickwork.brick.height));
    };
    FaceCount count;
    for (std::size_t k = 0; k < marked.size(); ++k)
        for (const Box& box : marked[k].boxes) {
            const std::vector<cv::Point> region{place(box.min.x, box.min.y), place(box.max.x, box.min.y),
                                                place(box.max.x, box.max.y), place(box.min.x, box.max.y)};
            ++count.whole;
            count.found += shown_share(level, static_cast<int>(k), region, strip) >= whole_share ? 1 : 0;
        }
    return count;
}

FaceCount count_faces(const LoadedLevel& level, const cv::Mat& strip, FaceDetector& detector) {
    std::vector<cv::Rect> there = faces_in_strip(strip, detector);
    FaceCount count;
    for (int k = 0; k < level.brickwork.keyframes; ++k) {
        const cv::Size brick = level.brickwork.brick;
        for (const cv::Rect& face :
             faces_in(level.keyframes[static_cast<std::size_t>(k)].picture, detector)) {
            const bool is_whole =
                face.x > 1 && face.y > 1 && face.br().x < brick.width - 1 && face.br().y < brick.height - 1;
            if (!is_whole) continue;
            ++count.whole;
            const int middle = level.brickwork.place(k).x + face.x + face.width / 2;
            const auto again = std::ranges::find_if(there, [&](const cv::Rect& other) {
                return std::abs(other.x + other.width / 2 - middle) <= brick.width / 2 &&
                       3 * other.height >= 2 * face.height;
            });
            if (again == there.end()) continue;
            ++count.found;
            there.erase(again);
        }
    }
    return count;
}

}  // namespace vitrine::analyzer
