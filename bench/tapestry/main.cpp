// Measures the cost of a film's tapestry and its quality, in processor time; ratios are within one run.
//   tapestry_bench FILM... [--face-model M] [--pictures DIR] [--long SECONDS] [--brick-height PX]
//   [--marks boxes.json]

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/tapestry/weave/candidate_writer.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "bench/tapestry/measures.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace vitrine::analyzer {
namespace {

/// Repeats the film until it has `count` frames.
std::vector<FrameSignature> repeated(const std::vector<FrameSignature>& frames, int count) {
    std::vector<FrameSignature> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(frames[static_cast<std::size_t>(i) % frames.size()]);
        all.back().time = std::chrono::milliseconds(500 * i);
    }
    return all;
}

void time_keyframes(const std::vector<FrameSignature>& frames, int seconds) {
    const std::vector<FrameSignature> film = repeated(frames, 2 * seconds);
    const CpuTime affinity_time;
    const Affinity costs = affinity(film);
    const double compared = affinity_time.seconds();
    const CpuTime cluster_time;
    const std::vector<Keyframes> levels = keyframe_levels(costs);
    fmt::print("keyframes of {} s at 2 fps: affinity {:.1f} s, {} levels {:.1f} s of CPU\n", seconds,
               compared, levels.size(), cluster_time.seconds());
}

void measure_tiles(const LoadedLevel& level, TileQuality quality, const cv::Mat& strip, double seconds) {
    const Brickwork& brickwork = level.brickwork;
    const std::vector<TileSpan> spans = tile_spans(brickwork.width(), brickwork.brick.height);
    const cv::Mat plain = squeezed(level);
    double own = 0;
    double of_plain = 0;
    for (const TileSpan& span : spans) {
        own += distance(level, span, strip);
        of_plain += distance(level, span, plain);
    }
    const auto tiles = static_cast<double>(spans.size());
    fmt::print(
        "  {}: {:.3f} s of CPU a tile of {:.0f} px; distance {:.1f} against {:.1f} squeezed: {:.0f} %\n",
        quality == TileQuality::high ? "high" : "on demand", seconds / tiles,
        (brickwork.width() + (tiles - 1) * tile_overlap(brickwork.brick.height)) / tiles, own / tiles,
        of_plain / tiles, 100 * own / of_plain);
}

void print_borders(const LoadedLevel& level, const cv::Mat& strip, std::string_view what) {
    const Gradients found = gradients(level, strip);
    fmt::print("  {}: squared steps inside {:.0f}, at tile borders {:.0f}, at brick borders {:.0f}; down "
               "inside {:.0f}, "
               "between the rows {:.0f}\n",
               what, found.inside, found.tile_borders, found.brick_borders, found.row_inside,
               found.row_border);
}

/// The options of one measurement.
struct Measuring {
    std::filesystem::path pictures;
    int long_film = 0;  // seconds
    int brick_height = usual_brick_height;
    int region_weight = WindowSettings{}.region_weight;
    std::filesystem::path marks;  // of the subjects in some frames; empty: not asked for
};

std::unique_ptr<FrameSource> opened(const std::string& path, const Measuring& how) {
    return open_media(path, 320 * how.brick_height / usual_brick_height);
}

/// Weaves the frames that somebody has marked, and tells which of the marked subjects are whole in it.
void measure_marked(const Film& film, const std::string& path, const Measuring& how) {
    const std::vector<MarkedFrame> marked = marked_frames(how.marks, path);
    if (marked.size() < 2) return;  // the tapestry of one keyframe is the keyframe
    const auto again = opened(path, how);
    const LoadedLevel level = loaded(film, keyframes_at(film, marked, *again));
    const cv::Mat strip = woven(level, TileQuality::high, how.region_weight);
    const FaceCount subjects = count_marked(film, level, marked, strip);
    fmt::print("  marked subjects in {} keyframes {}, whole in the tapestry {}, squeezed {}\n", marked.size(),
               subjects.whole, subjects.found, count_marked(film, level, marked, squeezed(level)).found);
    if (how.pictures.empty()) return;
    cv::Mat sheet;
    cv::vconcat(bricks_picture(level), strip, sheet);
    write_png(how.pictures / (std::filesystem::path(path).stem().string() + "-marked.png"), sheet);
}

void measure(const std::string& path, FaceDetector* detector, const Measuring& how) {
    const auto source = opened(path, how);
    const Film film = analysed(*source, detector, how.brick_height);
    const auto& signatures = film.candidates->signatures();
    fmt::print("{}: {} candidates\n", path, signatures.size());
    if (how.long_film > 0) time_keyframes(signatures, how.long_film);
    const LoadedLevel level =
        loaded(film, chosen_keyframes(*film.candidates, {.max_levels = 1}, run_in_order)[0]);
    fmt::print("  {} keyframes, {} of {} neighbouring pairs nearly alike\n", level.keyframes.size(),
               pairs_alike(level), level.keyframes.size() - 1);
    cv::Mat sheet;
    cv::vconcat(filmstrip(level), bricks_picture(level), sheet);
    for (const TileQuality quality : {TileQuality::on_demand, TileQuality::high}) {
        const CpuTime time;
        const cv::Mat strip = woven(level, quality, how.region_weight);
        measure_tiles(level, quality, strip, time.seconds());
        print_borders(level, strip, "borders");
        if (detector != nullptr) {
            const FaceCount faces = count_faces(level, strip, *detector);
            const FaceCount plain = count_faces(level, squeezed(level), *detector);
            fmt::print("  faces whole in keyframes {}, in the tapestry {}, squeezed {}\n", faces.whole,
                       faces.found, plain.found);
        }
        const FaceCount subjects = count_subjects(level, strip);
        fmt::print("  regions whole in keyframes {}, in the tapestry {}, squeezed {}\n", subjects.whole,
                   subjects.found, count_subjects(level, squeezed(level)).found);
        cv::vconcat(sheet, strip, sheet);
    }
    print_borders(level, squeezed(level), "squeezed bricks");
    if (!how.marks.empty()) measure_marked(film, path, how);
    if (how.pictures.empty()) return;
    write_png(how.pictures / (std::filesystem::path(path).stem().string() + "-compared.png"), sheet);
}

int run(int argc, char** argv) {
    std::vector<std::string> films;
    std::string model;
    Measuring how;
    CLI::App app("Cost and quality of tapestries.");
    app.add_option("FILM", films)->required();
    app.add_option("--face-model", model);
    app.add_option("--pictures", how.pictures, "Where filmstrip, bricks and tapestries go, below each other");
    app.add_option("--long", how.long_film, "Compare and cluster the frames repeated to so many seconds");
    app.add_option("--brick-height", how.brick_height, "Pixels of the analysed frames; 100 without it");
    app.add_option("--region-weight", how.region_weight, "1: regions weigh as all else");
    app.add_option("--marks", how.marks, "boxes.json: count the marked subjects that stay whole");
    CLI11_PARSE(app, argc, argv);
    const auto detector = face_detector(model, "");
    for (const std::string& film : films)
        measure(film, detector.get(), how);
    return 0;
}

}  // namespace
}  // namespace vitrine::analyzer

int main(int argc, char** argv) {
    return vitrine::analyzer::run(argc, argv);
}
