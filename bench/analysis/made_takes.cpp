#include "bench/analysis/made_takes.hpp"

#include "bench/analysis/region_score.hpp"

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr double pi = std::numbers::pi;
const cv::Size frame_size(480, 270);
constexpr double fps = 25;
constexpr int drawn_scenes = 3;
constexpr double world_scale = 1.7;  // a photograph's width in the world, in widths of the frame

/// The place that a camera looks at or a subject stands on, at a time from 0 to 1 of the take: frame widths,
/// x right, y down.
struct Pose {
    Vec2 at;
    double scale = 1;
};

using Path = std::function<Pose(double)>;

struct Recipe {
    const char* name;
    double seconds = 3;
    Path camera;                 // offset over the world
    std::vector<Path> subjects;  // their centres in the world, from the first picture's middle
    double size = 0.3;           // share of the frame's height
    double noise = 2;            // grey levels
};

Path still() {
    return [](double) { return Pose{}; };
}

Path line(Vec2 from, Vec2 to) {
    return [=](double t) { return Pose{from + (to - from) * t}; };
}

Path shaken(const Path& path, double strength) {
    return [=](double t) {
        Pose pose = path(t);
        pose.at =
            pose.at + Vec2{std::sin(23 * t) + 0.6 * std::sin(61 * t + 1), std::sin(31 * t + 2)} * strength;
        return pose;
    };
}

Path scaled(const Path& path, double from, double to) {
    return [=](double t) {
        Pose pose = path(t);
        pose.scale = from * std::pow(to / from, t);
        return pose;
    };
}

/// Runs in from one side during the first part of the take and is gone afterwards.
Path hurried(Vec2 from, Vec2 to, double part) {
    return [=](double t) { return Pose{t < part ? from + (to - from) * (t / part) : Vec2{9, 9}}; };
}

Path there_and_back(Vec2 from, Vec2 to) {
    return [=](double t) { return Pose{from + (to - from) * std::sin(pi * t)}; };
}

const std::vector<Recipe>& recipes() {
    static const std::vector<Recipe> all{
        {"strolls", 4, still(), {line({-0.2, 0.05}, {0, 0.05})}},
        {"strolls, handheld", 4, shaken(still(), 0.004), {line({0.1, 0.02}, {0.28, -0.02})}, 0.4},
        {"crosses", 3, still(), {line({-0.42, 0.06}, {0.42, 0.02})}, 0.25},
        {"crosses upwards", 3, still(), {line({-0.15, 0.24}, {0.1, -0.2})}, 0.25},
        {"crosses slowly", 8, still(), {line({-0.35, 0.08}, {0.35, 0.08})}, 0.3},
        {"runs through, then nothing", 5, still(), {hurried({-0.6, 0.05}, {0.6, 0}, 0.3)}, 0.25},
        {"followed by a pan", 3, line({0, 0}, {0.9, 0}), {line({0.08, 0.04}, {0.98, 0.02})}, 0.4},
        {"followed by a fast pan", 2, line({0, 0}, {1.6, 0}), {line({-0.1, 0.04}, {1.55, 0.02})}, 0.35},
        {"followed, handheld",
         4,
         shaken(line({0, 0}, {-0.7, 0.1}), 0.006),
         {shaken(line({0.12, 0}, {-0.58, 0.1}), 0.004)},
         0.45},
        {"walks in a pan", 3, line({0, 0}, {0.3, 0}), {line({0.2, 0.03}, {0.1, 0.03})}, 0.3},
        {"overtakes the pan", 3, line({0, 0}, {0.4, 0.02}), {line({-0.2, 0.03}, {0.55, 0.06})}, 0.3},
        {"two part", 4, still(), {line({-0.05, 0.03}, {-0.3, 0.03}), line({0.08, 0}, {0.3, 0.05})}, 0.25},
        {"two together", 4, still(), {line({-0.3, 0.03}, {0, 0.03}), line({-0.12, 0}, {0.2, 0.05})}, 0.25},
        {"stands and moves a little", 4, still(), {shaken(line({0.2, 0.05}, {0.2, 0.05}), 0.006)}, 0.5},
        {"stands, handheld", 4, shaken(still(), 0.006), {line({-0.22, 0.04}, {-0.22, 0.04})}, 0.45},
        {"stands, the camera zooms in", 4, scaled(still(), 1, 1.6), {line({0.1, 0.03}, {0.1, 0.03})}, 0.3},
        {"comes nearer", 4, still(), {scaled(line({0.2, -0.02}, {0.1, 0.03}), 0.6, 1.8)}, 0.35},
        {"turns back", 5, still(), {there_and_back({-0.3, 0.03}, {0.15, 0.03})}, 0.3},
        {"fills the picture", 4, still(), {shaken(line({-0.05, 0.05}, {0.05, 0.05}), 0.006)}, 0.95},
        {"small and fast in noise", 3, still(), {line({-0.38, -0.1}, {0.38, 0.08})}, 0.12, 5},
        {"strolls in noise", 4, still(), {line({0.25, 0.05}, {0.1, 0.05})}, 0.35, 6},
    };
    return all;
}

/// A photograph's middle inside an outline that beats.
struct CutOut {
    cv::Mat picture;
    std::array<double, 3> lobes{};
    double width = 0.7;  // share of its height
};

CutOut cut_out(const cv::Mat& photo, cv::RNG& random) {
    const int side = std::min(photo.cols, photo.rows) * 2 / 3;
    CutOut result;
    cv::resize(photo(cv::Rect((photo.cols - side) / 2, (photo.rows - side) / 2, side, side)), result.picture,
               {200, 200}, 0, 0, cv::INTER_AREA);
    for (double& lobe : result.lobes)
        lobe = random.uniform(0.0, 2 * pi);
    result.width = random.uniform(0.5, 1.2);
    return result;
}

cv::Mat outline(const CutOut& subject, double seconds) {
    cv::Mat mask = cv::Mat::zeros(subject.picture.size(), CV_8UC1);
    std::vector<cv::Point> points;
    const double narrow = std::min(1.0, subject.width);
    const double low = std::min(1.0, 1 / subject.width);
    for (int k = 0; k < 90; ++k) {
        const double a = 2 * pi * k / 90;
        const double r = 78 + 10 * std::sin(2 * a + subject.lobes[0] + 4 * seconds) +
                         8 * std::sin(3 * a + subject.lobes[1] - 6 * seconds) +
                         4 * std::sin(7 * a + subject.lobes[2]);
        points.emplace_back(cv::Point2d(100 + r * narrow * std::cos(a), 100 + r * low * std::sin(a)));
    }
    cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{points}, 255, cv::LINE_AA);
    return mask;
}

void paste(cv::Mat& frame, cv::Mat& mask, const CutOut& subject, Vec2 centre, double scale, double seconds) {
    const cv::Matx23d place(scale, 0, centre.x - 100 * scale, 0, scale, centre.y - 100 * scale);
    cv::Mat picture;
    cv::Mat alpha;
    cv::warpAffine(subject.picture, picture, place, frame.size(), cv::INTER_AREA);
    cv::warpAffine(outline(subject, seconds), alpha, place, frame.size(), cv::INTER_AREA);
    cv::Mat share;
    cv::cvtColor(alpha, share, cv::COLOR_GRAY2BGR);
    cv::Mat kept;
    cv::multiply(frame, cv::Scalar::all(255) - share, kept, 1.0 / 255);
    cv::multiply(picture, share, picture, 1.0 / 255);
    frame = kept + picture;
    mask |= alpha > 127;
}

/// A sky over a soft random ground.
cv::Mat landscape(int side, int seed) {
    cv::Mat result(side * 2 / 3, side, CV_8UC3);
    cv::RNG random(50 + static_cast<unsigned>(seed));
    random.fill(result, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(result, result, {0, 0}, 2.0 + 3.0 * seed);
    cv::normalize(result, result, 40, 160, cv::NORM_MINMAX);
    const int horizon = result.rows * (2 + seed % 3) / 5;
    for (int y = 0; y < horizon; ++y)
        result.row(y).setTo(cv::Scalar(230 - y / 4.0, 200 - y / 3.0, 160 - y / 3.0));
    return result;
}

const cv::Mat& one_of(const std::vector<cv::Mat>& pictures, cv::RNG& random) {
    return pictures[static_cast<std::size_t>(random.uniform(0, static_cast<int>(pictures.size())))];
}

void add_noise(cv::Mat& frame, double strength, double t, cv::RNG& random) {
    cv::Mat noise(frame.size(), CV_16SC3);
    random.fill(noise, cv::RNG::NORMAL, 0, strength);
    cv::Mat sum;
    frame.convertTo(sum, CV_16SC3, 1 + 0.015 * std::sin(40 * t));
    sum += noise;
    sum.convertTo(frame, CV_8UC3);
}

}  // namespace

std::size_t made_take_count() {
    return recipes().size();
}

Take made_take(std::size_t number, const Palette& palette) {
    const Recipe& recipe = recipes()[number % recipes().size()];
    cv::RNG random(1000 + number);
    const cv::Mat& photo = one_of(palette.scenes, random);
    cv::Mat world;
    const double zoom = world_scale * frame_size.width / photo.cols;
    cv::resize(photo, world, {}, zoom, zoom, zoom < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    std::vector<CutOut> cast;
    for (std::size_t i = 0; i < recipe.subjects.size(); ++i) {
        const cv::Mat& model = one_of(palette.subjects, random);
        cast.push_back(cut_out(model, random));
    }
    Take take{.name = recipe.name, .fps = fps, .frames = {}, .masks = {}};
    const int count = static_cast<int>(recipe.seconds * fps);
    const Vec2 middle{frame_size.width / 2.0, frame_size.height / 2.0};
    const Vec2 world_middle{world.cols * 0.5, world.rows * 0.5};
    const double unit = frame_size.width;
    for (int i = 0; i < count; ++i) {
        const double t = i / (count - 1.0);
        const Pose camera = recipe.camera(t);
        const Vec2 shift = middle - (world_middle + camera.at * unit) * camera.scale;
        cv::Mat frame;
        cv::warpAffine(world, frame, cv::Matx23d(camera.scale, 0, shift.x, 0, camera.scale, shift.y),
                       frame_size, cv::INTER_LINEAR, cv::BORDER_REFLECT_101);
        cv::Mat mask = cv::Mat::zeros(frame_size, CV_8UC1);
        for (std::size_t k = 0; k < cast.size(); ++k) {
            const Pose pose = recipe.subjects[k](t);
            const Vec2 centre = middle + (pose.at - camera.at) * (unit * camera.scale);
            const double scale = recipe.size * frame_size.height / 170 * pose.scale * camera.scale;
            paste(frame, mask, cast[k], centre, scale, i / fps);
        }
        add_noise(frame, recipe.noise, i / fps, random);
        take.frames.push_back(frame);
        take.masks.push_back(mask);
    }
    return take;
}

Palette palette(const fs::path& media, int side) {
    Palette result;
    for (int i = 0; i < drawn_scenes; ++i)
        result.scenes.push_back(landscape(side, i));
    std::ifstream file(media / "photos" / "boxes.json");
    const nlohmann::json labels = file ? nlohmann::json::parse(file)["images"] : nlohmann::json::object();
    for (const auto& [name, entry] : labels.items()) {
        const cv::Mat photo = picture(media / "photos" / name, side);
        if (!photo.empty())
            (boxes(entry, "subject").empty() ? result.scenes : result.subjects).push_back(photo);
    }
    if (result.subjects.empty()) result.subjects.push_back(landscape(side, drawn_scenes));
    return result;
}

}  // namespace vitrine::analyzer
