#include "analyzer/tapestry/synthesis/weave.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

namespace {

BrickSection section_of(const LevelBricks& level, const TileSpan& tile) {
    const Brickwork& brickwork = level.brickwork;
    const cv::Range window = window_of(brickwork, tile);
    BrickSection section{.brickwork = brickwork, .bricks = {}, .first = brickwork.first_at(window.start)};
    for (int brick = section.first; brick < brickwork.last_at(window.end); ++brick)
        section.bricks.push_back(level.keyframe(std::min(brick, brickwork.keyframes - 1)));
    return section;
}

/// A single keyframe stands alone, as tall as the tapestry: two of it would tell nothing more.
void show_whole(const LevelBricks& level, const ColumnSink& sink) {
    cv::Mat strip;
    cv::resize(level.keyframe(0).picture, strip, {level.brickwork.width(), tapestry_height(level.brickwork)},
               0, 0, cv::INTER_CUBIC);
    sink(strip, {.tiles = tile_spans(strip.cols, level.brickwork.brick.height).size(), .border = {}});
}

}  // namespace

void weave_level(const LevelBricks& bricks, const ColumnSink& sink, const RetargetSettings& settings,
                 const RunTasks& run, WovenSoFar done) {
    if (bricks.brickwork.keyframes == 1) return show_whole(bricks, sink);
    const Brickwork& brickwork = bricks.brickwork;
    const std::vector<TileSpan> spans = tile_spans(brickwork.width(), brickwork.brick.height);
    TileNeighbours neighbours{.left = std::move(done.border), .right = {}};
    for (std::size_t i = done.tiles; i < spans.size(); ++i) {
        const cv::Mat tile = retarget_tile(section_of(bricks, spans[i]), spans[i], neighbours, settings, run);
        const bool is_last = i + 1 == spans.size();
        const int finished = is_last ? tile.cols : tile.cols - tile_overlap(brickwork.brick.height);
        neighbours.left = tile.colRange(finished, tile.cols).clone();
        sink(tile.colRange(0, finished), {.tiles = i + 1, .border = neighbours.left});
    }
}

}  // namespace vitrine::analyzer
