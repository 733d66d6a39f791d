// Measures how many lines of text lie whole in the region, with the detector of lines and without it: on
// drawn slides, and on signs that are drawn into photographs. Tells of photographs as they are how much the
// region grows.

#include "analyzer/explain/canvas.hpp"
#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/subject_network.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "bench/analysis/cpu_time.hpp"
#include "bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int slides = 40;
constexpr double ink_edge = 2;  // px, soft at the ends of a line

constexpr std::array<std::string_view, 14> words{"Öffnungszeiten Montag bis Freitag",
                                                 "Tagesgericht 7,80 EUR",
                                                 "Room 214",
                                                 "WELCOME",
                                                 "Please ring the bell",
                                                 "Сегодня закрыто",
                                                 "Меню дня",
                                                 "ΑΝΟΙΧΤΑ",
                                                 "Sortie de secours",
                                                 "2 for 1 until Sunday",
                                                 "EXIT",
                                                 "Gate B 17 now boarding",
                                                 "Zum Kaffee ein Stück Kuchen",
                                                 "No entry"};

/// A picture with lines whose places are known.
struct Written {
    cv::Mat picture;
    std::vector<Box> lines;  // of their ink, px
};

Box drawn(Canvas& canvas, std::string_view line, Vec2 at, const TextStyle& style) {
    const cv::Mat before = canvas.picture().clone();
    canvas.text(line, at, style);
    cv::Mat changed;
    cv::absdiff(before, canvas.picture(), changed);
    cv::cvtColor(changed, changed, cv::COLOR_BGR2GRAY);
    const cv::Rect ink = cv::boundingRect(changed > 16);
    return {{static_cast<double>(ink.x), static_cast<double>(ink.y)},
            {static_cast<double>(ink.br().x), static_cast<double>(ink.br().y)}};
}

std::string_view any_words(cv::RNG& random) {
    return words[static_cast<std::size_t>(random.uniform(0, static_cast<int>(words.size())))];
}

/// A heading and two to six lines, on one colour.
Written slide(cv::RNG& random) {
    const bool is_dark = random.uniform(0, 2) == 1;
    Canvas canvas(640, 360, is_dark ? 0x102030 : 0xF4F0E4);
    const Ink ink = is_dark ? 0xF0F0F0 : 0x202830;
    Written written;
    const double left = random.uniform(20, 120);
    double y = random.uniform(40, 80);
    for (int i = random.uniform(3, 8); i-- > 0 && y < 330;) {
        const double size = written.lines.empty() ? random.uniform(26, 40) : random.uniform(12, 22);
        const std::string_view line = any_words(random);
        if (left + canvas.text_width(line, size) < 630)
            written.lines.push_back(drawn(canvas, line, {left, y}, {.size = size, .colour = ink}));
        y += 2.2 * size;
    }
    written.picture = canvas.picture().clone();
    return written;
}

/// A line, dark on a plate, or white without one.
struct Sign {
    std::string_view line;
    Vec2 at;          // px
    double size = 0;  // of its letters, px
    bool has_plate = true;
};

/// Draws a sign, unless it would cover another one.
void draw(const Sign& sign, Canvas& canvas, Written& written, cv::RNG& random) {
    const auto& [line, at, size, has_plate] = sign;
    const double width = canvas.text_width(line, size);
    const Box plate{at - Vec2{size / 2, size}, at + Vec2{width + size / 2, size}};
    const bool is_free = std::ranges::none_of(
        written.lines, [&](const Box& other) { return !intersection(plate, other).is_empty(); });
    if (!is_free) return;
    if (has_plate) canvas.fill(plate, random.uniform(0, 2) == 1 ? 0xF8F8F0 : 0xE0C020);
    const Ink colour = has_plate ? 0x101010 : 0xFFFFFF;
    written.lines.push_back(drawn(canvas, line, at, {.size = size, .colour = colour}));
}

/// One or two plates with a line each, somewhere on a photograph.
Written signs(const cv::Mat& photo, cv::RNG& random) {
    Canvas canvas(photo.cols, photo.rows, 0);
    canvas.place(photo, {});
    Written written;
    for (int i = random.uniform(1, 3); i-- > 0;) {
        const double size = random.uniform(0.03, 0.1) * std::min(photo.cols, photo.rows);
        const std::string_view line = any_words(random);
        const double width = canvas.text_width(line, size);
        if (width + 3 * size > photo.cols) continue;
        const Vec2 at{random.uniform(size, photo.cols - width - size),
                      random.uniform(2 * size, photo.rows - 2 * size)};
        draw({line, at, size}, canvas, written, random);
    }
    written.picture = canvas.picture().clone();
    return written;
}

/// Two lines, with plates or without, that end less than half a letter's height from an edge of the
/// photograph.
Written lines_at_edges(const cv::Mat& photo, cv::RNG& random) {
    Canvas canvas(photo.cols, photo.rows, 0);
    canvas.place(photo, {});
    Written written;
    for (int i = 0; i < 2; ++i) {
        const double size = random.uniform(0.03, 0.1) * std::min(photo.cols, photo.rows);
        const std::string_view line = any_words(random);
        const double width = canvas.text_width(line, size);
        const Vec2 room{photo.cols - width, photo.rows - size};
        if (room.x < 3 * size) continue;
        const double gap = random.uniform(0.0, 0.5) * size;
        Vec2 at{random.uniform(size, room.x - size), random.uniform(2 * size, room.y - size)};
        switch (random.uniform(0, 4)) {
        case 0:
            at.x = gap;
            break;
        case 1:
            at.x = room.x - gap;
            break;
        case 2:
            at.y = size / 2 + gap;
            break;
        default:
            at.y = room.y + size / 2 - gap;
        }
        const bool has_plate = random.uniform(0, 2) == 1;
        draw({line, at, size, has_plate}, canvas, written, random);
    }
    written.picture = canvas.picture().clone();
    return written;
}

/// The detectors that find a photo's region.
struct Finders {
    std::unique_ptr<FaceDetector> faces;
    std::unique_ptr<SaliencyNetwork> network;
    LineDetector lines;
};

struct Regions {
    Polygon with_lines;
    Polygon without;
    std::size_t lines = 0;  // found
    double line_cpu = 0;    // seconds
};

Regions regions_of(const cv::Mat& photo, Finders& finders) {
    const AnalysisSettings settings;
    const FramePair pair{photo, {}, 1};
    const std::vector<Face> faces = find_faces(*finders.faces, photo, settings.only_prominent_faces);
    Sample sample = sample_of(pair, settings, faces);
    sample.faces = faces;
    sample.subject = find_subject(*finders.network, pair);
    const auto region = [&] {
        return shot_region({sample}, {}, map_size(photo.size()), photo.size(), settings).shot.region.polygon;
    };
    Regions regions{.with_lines = {}, .without = region()};
    const double begin = cpu_seconds();
    sample.lines = find_lines(finders.lines, pair);
    regions.line_cpu = cpu_seconds() - begin;
    regions.lines = sample.lines.size();
    regions.with_lines = region();
    return regions;
}

bool is_whole(const Polygon& region, const Box& line) {
    const Box core{line.min + Vec2{ink_edge, ink_edge}, line.max - Vec2{ink_edge, ink_edge}};
    return std::ranges::all_of(to_polygon(core),
                               [&](Vec2 corner) { return is_inside_convex(region, corner); });
}

/// The sums of one row of the table.
struct Row {
    int pictures = 0;
    int lines = 0;
    int whole = 0;
    int whole_without = 0;
    std::size_t found = 0;
    double area = 0;
    double area_without = 0;
    double cpu = 0;

    void add(const Written& written, Finders& finders) {
        const Regions regions = regions_of(written.picture, finders);
        const auto pixels = static_cast<double>(written.picture.total());
        ++pictures;
        lines += static_cast<int>(written.lines.size());
        for (const Box& line : written.lines) {
            whole += is_whole(regions.with_lines, line) ? 1 : 0;
            whole_without += is_whole(regions.without, line) ? 1 : 0;
        }
        found += regions.lines;
        area += vitrine::area(regions.with_lines) / pixels;
        area_without += vitrine::area(regions.without) / pixels;
        cpu += regions.line_cpu;
    }

    void print(std::string_view name) const {
        const int count = std::max(pictures, 1);
        fmt::print(
            "  {:32} {:3} pictures: lines whole {} of {}, without the detector {}; area {:.3f}, without "
            "{:.3f}; {:.1f} lines found and {:.2f} s of CPU a picture\n",
            name, pictures, whole, lines, whole_without, area / count, area_without / count,
            static_cast<double>(found) / count, cpu / count);
    }
};

std::vector<fs::path> photos_in(const fs::path& media) {
    std::vector<fs::path> photos;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(media / "photos"))
        if (entry.path().extension() == ".jpg") photos.push_back(entry.path());
    std::ranges::sort(photos);
    return photos;
}

}  // namespace

void words_table(const TableInput& input) {
    fmt::print("lines of text (no value was fitted to photos with an odd number)\n");
    Finders finders{.faces = face_detector(input.face_model, ""),
                    .network = open_network(input.saliency_model, full_side),
                    .lines = LineDetector(input.text_model)};
    cv::RNG random(17);
    Row drawn_slides;
    for (int i = 0; i < slides; ++i)
        drawn_slides.add(slide(random), finders);
    drawn_slides.print("slides");
    std::array<Row, 2> with_signs;
    std::array<Row, 2> plain;
    std::array<Row, 2> at_edges;
    cv::RNG random_edges(18);
    const std::vector<fs::path> photos = photos_in(input.media);
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const cv::Mat photo = open_media(photos[i].string())->next()->picture;
        with_signs[i % 2].add(signs(photo, random), finders);
        at_edges[i % 2].add(lines_at_edges(photo, random_edges), finders);
        plain[i % 2].add({.picture = photo, .lines = {}}, finders);
        if (input.is_verbose) plain[i % 2].print(photos[i].filename().string());
    }
    with_signs[0].print("signs, even photos");
    with_signs[1].print("signs, odd photos");
    at_edges[0].print("lines at edges, even photos");
    at_edges[1].print("lines at edges, odd photos");
    plain[0].print("even photos as they are");
    plain[1].print("odd photos as they are");
}

}  // namespace vitrine::analyzer
