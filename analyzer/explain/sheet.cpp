#include "analyzer/explain/sheet.hpp"

#include "analyzer/explain/time_line.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

constexpr int margin = 48;
constexpr int cell_width = 256;
constexpr int tallest_cell = 240;
constexpr int gap = 14;
constexpr int columns = 7;
constexpr int header_height = 104;
constexpr int column_titles_height = 34;
constexpr int row_title_height = 34;
constexpr int row_gap = 22;
constexpr int sheet_width = 2 * margin + columns * cell_width + (columns - 1) * gap;
constexpr Ink paper = 0xFBFAF8;
constexpr Ink ink = 0x1C1B1A;
constexpr Ink faint_ink = 0x76726D;
constexpr Ink no_map = 0xECE9E5;
constexpr Ink region_colour = 0xFF8A00;
constexpr Ink end_colour = 0x00C8E0;
constexpr Ink face_colour = 0x4CE06A;
constexpr double dimmed = 0.4;  // brightness outside the region

struct Cell {
    Vec2 at;
    cv::Size size;
};

cv::Size cell_size(const MediaRecord& record) {
    const double scale = std::min(static_cast<double>(cell_width) / record.width,
                                  static_cast<double>(tallest_cell) / record.height);
    return {std::max(1, static_cast<int>(std::lround(record.width * scale))),
            std::max(1, static_cast<int>(std::lround(record.height * scale)))};
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

void draw_map(Canvas& canvas, const Cell& cell, const SaliencyMap& map, double highest,
              const char* otherwise) {
    if (!map.empty()) {
        canvas.place(fitted(coloured(map, highest), cell.size), cell.at);
        return;
    }
    const Vec2 size{static_cast<double>(cell.size.width), static_cast<double>(cell.size.height)};
    canvas.fill({cell.at, cell.at + size}, no_map);
    const int width = canvas.text_width(otherwise, 13);
    canvas.text(otherwise, cell.at + Vec2{(size.x - width) / 2, size.y / 2}, 13, faint_ink);
}

double highest_of(const SaliencyMap& map) {
    double highest = 0;
    cv::minMaxLoc(map, nullptr, &highest);
    return highest;
}

Polygon on_cell(const Polygon& source, Vec2 offset, double scale, const Cell& cell) {
    return transformed(source, scale, offset * scale + cell.at);
}

/// The frame dimmed outside the region as it lies then; at the shot's end, where it drifts, in a second
/// colour.
void draw_region(Canvas& canvas, const Cell& cell, const ShotEvidence& row, double scale) {
    const IRegion& region = row.shot.region;
    const auto seconds = [](std::chrono::nanoseconds t) { return std::chrono::duration<double>(t).count(); };
    const Vec2 moved_by = region.drift * seconds(row.picture_time - row.shot.begin);
    cv::Mat frame = fitted(row.picture, cell.size);
    cv::Mat mask = cv::Mat::zeros(cell.size, CV_8UC1);
    std::vector<cv::Point> points;
    for (const Vec2 p : transformed(region.polygon, scale, moved_by * scale)) {
        points.emplace_back(cv::Point2d(p.x - 0.5, p.y - 0.5));
    }
    cv::fillConvexPoly(mask, points, 255, cv::LINE_AA);
    cv::Mat dim = frame * dimmed;
    frame.copyTo(dim, mask);
    canvas.place(dim, cell.at);
    canvas.outline(on_cell(region.polygon, moved_by, scale, cell), region_colour, 2);
    if (region.drift == Vec2{}) return;
    const Box picture{cell.at, cell.at + Vec2{cell.size.width - 1.0, cell.size.height - 1.0}};
    const Vec2 end = region.drift * seconds(row.shot.duration());
    canvas.outline(clipped(on_cell(region.polygon, end, scale, cell), picture), end_colour, 1);
}

std::string row_title(const ShotEvidence& row, const MediaRecord& record, std::size_t number) {
    const double share = area(row.shot.region.polygon) / (static_cast<double>(record.width) * record.height);
    std::string region = fmt::format("region {:.0f} % of the picture", share * 100);
    if (record.kind == MediaKind::photo) return region;
    std::string title = fmt::format("shot {}   {} to {}   {} samples   {}", number, time_text(row.shot.begin),
                                    time_text(row.shot.end), row.samples, region);
    const Vec2 drift = row.shot.region.drift;
    if (drift == Vec2{}) return title + "   still";
    return title + fmt::format("   moves {:+.0f}, {:+.0f} px/s", drift.x, drift.y);
}

void draw_row(Canvas& canvas, double top, const ShotEvidence& row, const MediaRecord& record,
              std::size_t number) {
    canvas.text(row_title(row, record, number), {margin, top + row_title_height / 2.0}, 14, ink);
    const cv::Size size = cell_size(record);
    const auto cell = [&](int column) {
        const double x = margin + column * (cell_width + gap) + (cell_width - size.width) / 2.0;
        return Cell{{x, top + row_title_height}, size};
    };
    const double scale = static_cast<double>(size.width) / record.width;
    draw_map(canvas, cell(1), row.motion, 1, "no frame before");
    draw_map(canvas, cell(2), row.image, 1, "no sample");
    draw_map(canvas, cell(3), row.faces.empty() ? SaliencyMap() : row.face, 1, "no face");
    draw_map(canvas, cell(4), row.combined, row.combined.empty() ? 1 : highest_of(row.combined), "no sample");
    draw_map(canvas, cell(5), row.volume, highest_of(row.volume), "");
    if (row.picture.empty()) {
        draw_map(canvas, cell(0), {}, 1, "no sample");
        draw_map(canvas, cell(6), {}, 1, "no sample");
        return;
    }
    canvas.place(fitted(row.picture, size), cell(0).at);
    for (const Face& face : row.faces) {
        const double face_scale = static_cast<double>(size.width) / row.image.cols;
        canvas.outline(transformed(to_polygon(face.box), face_scale, cell(0).at), face_colour, 1);
    }
    draw_region(canvas, cell(6), row, scale);
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

void draw_column_titles(Canvas& canvas, double top) {
    constexpr std::array<const char*, columns> titles{
        "frame", "S_M motion contrast", "S_I image", "S_F faces", "S combined", "S_c accumulated", "region"};
    for (int i = 0; i < columns; ++i) {
        const double x = margin + i * (cell_width + gap);
        canvas.text(titles[static_cast<std::size_t>(i)], {x, top + column_titles_height / 2.0}, 13, faint_ink,
                    TextWeight::bold);
    }
}

std::size_t number_of(const Shot& shot, const MediaRecord& record) {
    const auto found = std::find(record.shots.begin(), record.shots.end(), shot);
    return static_cast<std::size_t>(found - record.shots.begin()) + 1;
}

}  // namespace

void LongestShots::add(ShotEvidence evidence) {
    shots_.push_back(std::move(evidence));
    if (shots_.size() <= most_) return;
    shots_.erase(
        std::min_element(shots_.begin(), shots_.end(), [](const ShotEvidence& a, const ShotEvidence& b) {
            return a.shot.duration() < b.shot.duration();
        }));
}

Canvas drawn_sheet(const SheetTitle& title, const MediaRecord& record,
                   const std::vector<ShotEvidence>& rows) {
    const int line_height = record.kind == MediaKind::photo ? 0 : time_line_height;
    const int row_height = row_title_height + cell_size(record).height + row_gap;
    const int height = margin + header_height + line_height + column_titles_height +
                       static_cast<int>(rows.size()) * row_height + margin - row_gap;
    Canvas canvas(sheet_width, height, paper);
    canvas.text(title.name, {margin, margin + 16.0}, 28, ink, TextWeight::bold, sheet_width - 2 * margin);
    canvas.text(facts(title, record, rows.size()), {margin, margin + 56.0}, 16, faint_ink);
    double top = margin + header_height;
    if (line_height > 0) {
        const Box place{{margin, top}, {static_cast<double>(sheet_width - margin), top + line_height}};
        draw_time_line(canvas, place, record, rows);
        top += line_height;
    }
    draw_column_titles(canvas, top);
    top += column_titles_height;
    for (const ShotEvidence& row : rows) {
        draw_row(canvas, top, row, record, number_of(row.shot, record));
        top += row_height;
    }
    return canvas;
}

}  // namespace vitrine
