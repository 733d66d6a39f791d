#include "analyzer/explain/sheet.hpp"

#include "analyzer/explain/time_line.hpp"
#include "analyzer/saliency/subject_outline.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr int margin = 48;
constexpr int max_frame_width = 400;
constexpr int max_frame_height = 300;
constexpr int gap = 14;
constexpr int group_gap = 34;  // between frames and maps
constexpr int label_height = 22;
constexpr int header_height = 132;
constexpr int row_title_height = 32;
constexpr int row_gap = 30;
constexpr int min_width = 1100;
constexpr int min_facts_width = 150;
constexpr Ink paper = 0xFBFAF8;
constexpr Ink ink = 0x1C1B1A;
constexpr Ink faint_ink = 0x76726D;
constexpr Ink no_map = 0xECE9E5;
constexpr Ink region_colour = 0xFF8A00;
constexpr Ink paper_mode_colour = 0xF03A9B;
constexpr Ink drift_colour = 0x00C8E0;
constexpr Ink face_colour = 0x4CE06A;
constexpr Ink line_colour = 0x46B4FF;
constexpr double dimmed = 0.45;  // brightness outside the region

struct Cell {
    Vec2 at;
    cv::Size size;
};

/// The places on the sheet of one file: one frame of a photo or three of each shot, and right of them two
/// rows of three maps.
struct Plan {
    int frames = 1;
    cv::Size frame;
    cv::Size map;

    double maps_x() const { return margin + frames * (frame.width + gap) - gap + group_gap; }

    int map_step() const { return std::max(map.width, min_facts_width) + gap; }

    int width() const {
        return std::max(min_width, static_cast<int>(maps_x()) + 3 * map_step() - gap + margin);
    }

    int row_height() const { return row_title_height + label_height + frame.height + row_gap; }

    Vec2 frame_at(int number, double top) const {
        return {margin + static_cast<double>(number) * (frame.width + gap),
                top + row_title_height + label_height};
    }

    Vec2 map_at(int column, int row, double top) const {
        return {maps_x() + static_cast<double>(column) * map_step(),
                top + row_title_height + label_height +
                    static_cast<double>(row) * (map.height + label_height)};
    }
};

Plan plan_of(const MediaRecord& record) {
    const double scale = std::min(static_cast<double>(max_frame_width) / record.width,
                                  static_cast<double>(max_frame_height) / record.height);
    const auto fit = [&](double s) {
        return cv::Size(std::max(1, static_cast<int>(std::lround(record.width * s))),
                        std::max(1, static_cast<int>(std::lround(record.height * s))));
    };
    Plan plan{.frames = record.kind == MediaKind::photo ? 1 : 3, .frame = fit(scale), .map = {}};
    const double map_height = std::max(24.0, (plan.frame.height - label_height) / 2.0);
    plan.map = fit(map_height / record.height);
    return plan;
}

cv::Mat fitted(const cv::Mat& picture, cv::Size size) {
    cv::Mat result;
    const bool is_smaller = picture.cols < size.width;
    cv::resize(picture, result, size, 0, 0, is_smaller ? cv::INTER_LINEAR : cv::INTER_AREA);
    return result;
}

/// A map of values up to `highest` as colours from black over red to yellow.
cv::Mat coloured(const SaliencyMap& map, double highest) {
    cv::Mat grey;
    map.convertTo(grey, CV_8UC1, highest > 0 ? 255 / highest : 0);
    cv::Mat result;
    cv::applyColorMap(grey, result, cv::COLORMAP_INFERNO);
    return result;
}

/// One of the maps beside the frames.
struct ShownMap {
    const char* name;
    SaliencyMap map;           // empty: there is none
    double highest = 1;        // the value of the brightest colour
    const char* absence = "";  // shown where there is none
};

void draw_map(Canvas& canvas, const Cell& cell, const ShownMap& shown) {
    canvas.text(shown.name, cell.at - Vec2{0, label_height / 2.0}, {12, faint_ink, TextWeight::bold});
    if (!shown.map.empty()) {
        canvas.place(fitted(coloured(shown.map, shown.highest), cell.size), cell.at);
        return;
    }
    const Vec2 size{static_cast<double>(cell.size.width), static_cast<double>(cell.size.height)};
    canvas.fill({cell.at, cell.at + size}, no_map);
    const int width = canvas.text_width(shown.absence, 12);
    canvas.text(shown.absence, cell.at + Vec2{(size.x - width) / 2, size.y / 2}, {12, faint_ink});
}

double highest_of(const SaliencyMap& map) {
    double highest = 0;
    cv::minMaxLoc(map, nullptr, &highest);
    return highest;
}

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

cv::Mat dimmed_outside(const cv::Mat& frame, const Polygon& region) {
    cv::Mat mask = cv::Mat::zeros(frame.size(), CV_8UC1);
    std::vector<cv::Point> points;
    for (const Vec2 p : region)
        points.emplace_back(cv::Point2d(p.x - 0.5, p.y - 0.5));
    cv::fillConvexPoly(mask, points, 255, cv::LINE_AA);
    cv::Mat result = frame * dimmed;
    frame.copyTo(result, mask);
    return result;
}

/// Draws a frame with the findings in it: the region as it lies then, that by the paper's letter, faces,
/// lines of text, and the way that the region still goes.
void draw_frame(Canvas& canvas, const Cell& cell, const ShotEvidence& row, const ShownFrame& shown,
                const MediaRecord& record) {
    const double scale = static_cast<double>(cell.size.width) / record.width;
    const IRegion& region = row.shot.region;
    const auto lies = [&](const IRegion& r, std::chrono::nanoseconds time) {
        return transformed(r.polygon, scale, r.drift * (scale * seconds(time - row.shot.begin)));
    };
    const Polygon now = lies(region, shown.time);
    const cv::Mat frame = fitted(shown.picture, cell.size);
    canvas.place(dimmed_outside(frame, now), cell.at);
    const Box picture{cell.at, cell.at + Vec2{cell.size.width - 1.0, cell.size.height - 1.0}};
    const auto outline = [&](const Polygon& polygon, Ink colour, int thickness) {
        canvas.outline(clipped(transformed(polygon, 1, cell.at), picture), colour, thickness);
    };
    if (!row.letter.polygon.empty()) outline(lies(row.letter, shown.time), paper_mode_colour, 1);
    for (const Face& face : shown.faces) {
        const double face_scale = static_cast<double>(cell.size.width) / row.volume.cols;
        outline(transformed(to_polygon(face.box), face_scale, {}), face_colour, 1);
    }
    for (const Box& line : shown.lines) {
        const double line_scale = static_cast<double>(cell.size.width) / row.volume.cols;
        outline(transformed(to_polygon(line), line_scale, {}), line_colour, 1);
    }
    outline(now, region_colour, 2);
    const Vec2 left = region.drift * (scale * seconds(row.shot.end - shown.time));
    if (length(left) < 4) return;
    const Vec2 from = centroid(now) + cell.at;
    canvas.arrow(from, from + left, drift_colour, 2);
}

double part_of(const IRegion& region, const MediaRecord& record) {
    return 100 * area(region.polygon) / (static_cast<double>(record.width) * record.height);
}

/// Why the region of a photo is as large as it is.
std::string reason_for_size(double certainty) {
    if (certainty >= sure_certainty) return "the network's outline";
    if (certainty >= blind_certainty) return "joined: it doubts";
    return "large: nothing stands out";
}

/// The words of the row, in the place of a sixth map.
void draw_facts(Canvas& canvas, const Cell& cell, const ShotEvidence& row, const MediaRecord& record) {
    std::vector<std::pair<std::string, Ink>> lines;
    lines.emplace_back(fmt::format("region {:.0f} %", part_of(row.shot.region, record)), ink);
    if (!row.letter.polygon.empty())
        lines.emplace_back(fmt::format("paper's letter {:.0f} %", part_of(row.letter, record)), ink);
    if (row.shot.certainty) {
        lines.emplace_back(fmt::format("network sure {:.0f} %", 100 * *row.shot.certainty), ink);
        lines.emplace_back(row.is_page ? "a page of text" : reason_for_size(*row.shot.certainty), faint_ink);
    }
    if (record.kind == MediaKind::film) {
        const Vec2 drift = row.shot.region.drift;
        lines.emplace_back(drift == Vec2{} ? "stands still"
                                           : fmt::format("moves {:+.0f}, {:+.0f} px/s", drift.x, drift.y),
                           ink);
        lines.emplace_back(fmt::format("{} samples", row.samples), faint_ink);
    }
    double y = cell.at.y + 8;
    for (const auto& [line, colour] : lines) {
        canvas.text(line, {cell.at.x, y}, {13, colour});
        y += 21;
    }
}

void draw_maps(Canvas& canvas, double top, const ShotEvidence& row, const MediaRecord& record,
               const Plan& plan) {
    const auto cell = [&](int column, int line) { return Cell{plan.map_at(column, line, top), plan.map}; };
    if (row.subject.empty())
        draw_map(canvas, cell(0, 0), {"S_M motion", row.motion, 1, "no frame before"});
    else
        draw_map(canvas, cell(0, 0), {"subject by the network", row.subject});
    draw_map(canvas, cell(1, 0), {"S_I image", row.image, 1, "no sample"});
    draw_map(canvas, cell(2, 0), {"S_F faces", row.faces.empty() ? SaliencyMap() : row.face, 1, "no face"});
    draw_map(canvas, cell(0, 1),
             {"S combined", row.combined, row.combined.empty() ? 1 : highest_of(row.combined), "no sample"});
    draw_map(canvas, cell(1, 1), {"S_c accumulated", row.volume, highest_of(row.volume)});
    draw_facts(canvas, cell(2, 1), row, record);
}

std::size_t number_of(const Shot& shot, const MediaRecord& record) {
    const auto found = std::find(record.shots.begin(), record.shots.end(), shot);
    return static_cast<std::size_t>(found - record.shots.begin()) + 1;
}

std::string row_title(const ShotEvidence& row, const MediaRecord& record) {
    return fmt::format("shot {}   {} to {}", number_of(row.shot, record), time_text(row.shot.begin),
                       time_text(row.shot.end));
}

void draw_row(Canvas& canvas, double top, const ShotEvidence& row, const MediaRecord& record,
              const Plan& plan) {
    const bool is_film = record.kind == MediaKind::film;
    if (is_film) canvas.text(row_title(row, record), {margin, top + 12}, {15, ink, TextWeight::bold});
    draw_maps(canvas, top, row, record, plan);
    constexpr std::array<const char*, 3> names{"begin", "middle", "end"};
    for (int i = 0; i < plan.frames; ++i) {
        const Cell cell{plan.frame_at(i, top), plan.frame};
        const auto index = static_cast<std::size_t>(i);
        if (row.frames.size() != names.size()) {
            draw_map(canvas, cell, {.name = "", .map = {}, .absence = "no sample"});
            continue;
        }
        const ShownFrame& shown = row.frames[index];
        const std::string label =
            is_film ? fmt::format("{}   {}", names[index], time_text(shown.time)) : "frame and region";
        canvas.text(label, cell.at - Vec2{0, label_height / 2.0}, {12, faint_ink, TextWeight::bold});
        draw_frame(canvas, cell, row, shown, record);
    }
}

void draw_legend(Canvas& canvas, double y, int width) {
    constexpr std::array<std::pair<const char*, Ink>, 5> entries{
        {{"region", region_colour},
         {"by the paper's letter", paper_mode_colour},
         {"where it moves to", drift_colour},
         {"face", face_colour},
         {"line of text", line_colour}}};
    double x = width - margin;
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
        x -= canvas.text_width(entry->first, 13);
        canvas.text(entry->first, {x, y}, {13, faint_ink});
        x -= 26;
        canvas.fill({{x, y - 1.5}, {x + 18, y + 1.5}}, entry->second);
        x -= 22;
    }
}

std::string facts(const SheetTitle& title, const MediaRecord& record, std::size_t rows) {
    std::string text = fmt::format("{}   {} × {} px", record.kind == MediaKind::photo ? "photo" : "film",
                                   record.width, record.height);
    if (title.bytes > 0) text += fmt::format("   {:.1f} MB", static_cast<double>(title.bytes) / 1e6);
    if (record.kind == MediaKind::photo) return text;
    text += fmt::format("   {}   {} {}", time_text(record.duration), record.shots.size(),
                        record.shots.size() == 1 ? "shot" : "shots");
    if (rows < record.shots.size()) text += fmt::format(", of which the {} longest are shown", rows);
    return text;
}

}  // namespace

void LongestShots::add(ShotEvidence evidence) {
    shots_.push_back(std::move(evidence));
    if (shots_.size() <= max_shots_) return;
    shots_.erase(
        std::min_element(shots_.begin(), shots_.end(), [](const ShotEvidence& a, const ShotEvidence& b) {
            return a.shot.duration() < b.shot.duration();
        }));
}

Canvas drawn_sheet(const SheetTitle& title, const MediaRecord& record,
                   const std::vector<ShotEvidence>& rows) {
    const int line_height = record.kind == MediaKind::photo ? 0 : time_line_height;
    const Plan plan = plan_of(record);
    const int height = margin + header_height + line_height +
                       static_cast<int>(rows.size()) * plan.row_height() - row_gap + margin;
    const int width = plan.width();
    Canvas canvas(width, height, paper);
    canvas.text(title.name, {margin, margin + 16.0}, {28, ink, TextWeight::bold}, width - 2 * margin);
    canvas.text(facts(title, record, rows.size()), {margin, margin + 56.0}, {16, faint_ink});
    draw_legend(canvas, margin + 56.0, width);
    double top = margin + header_height - (record.kind == MediaKind::photo ? 30 : 0);
    if (line_height > 0) {
        const Box place{{margin, top}, {static_cast<double>(width - margin), top + line_height}};
        draw_time_line(canvas, place, record, rows);
        top += line_height;
    }
    for (const ShotEvidence& row : rows) {
        draw_row(canvas, top, row, record, plan);
        top += plan.row_height();
    }
    return canvas;
}

}  // namespace vitrine::analyzer
