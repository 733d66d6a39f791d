#include "analyzer/tapestry/weave.hpp"

#include <algorithm>

namespace vitrine {

void weave_level(const Brickwork& brickwork, const std::function<Keyframe(int)>& keyframe,
                 const std::function<void(const cv::Mat&)>& sink, const RetargetSettings& settings,
                 const RunTasks& run) {
    const std::vector<TileSpan> spans = tile_spans(brickwork.width());
    TileNeighbours neighbours;
    for (const TileSpan& span : spans) {
        const cv::Range window = window_of(brickwork, span.from, span.to);
        std::vector<Keyframe> bricks;
        for (int brick = brickwork.first_at(window.start); brick < brickwork.last_at(window.end); ++brick)
            bricks.push_back(keyframe(std::min(brick, brickwork.keyframes - 1)));
        const cv::Mat tile = retarget_tile(brickwork, bricks, span, neighbours, settings, run);
        if (span.to == brickwork.width()) {
            sink(tile);
            return;
        }
        sink(tile.colRange(0, tile.cols - tile_overlap));
        neighbours.left = tile.colRange(tile.cols - tile_overlap, tile.cols).clone();
    }
}

}  // namespace vitrine
