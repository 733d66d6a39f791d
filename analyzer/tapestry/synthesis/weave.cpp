#include "analyzer/tapestry/synthesis/weave.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

void weave_level(const Brickwork& brickwork, const std::function<Keyframe(int)>& keyframe,
                 const ColumnSink& sink, const RetargetSettings& settings, const RunTasks& run,
                 WovenSoFar done) {
    const std::vector<TileSpan> spans = tile_spans(brickwork.width());
    TileNeighbours neighbours{.left = std::move(done.border), .right = {}};
    for (std::size_t i = done.tiles; i < spans.size(); ++i) {
        const TileSpan& span = spans[i];
        const cv::Range window = window_of(brickwork, span.from, span.to);
        std::vector<Keyframe> bricks;
        for (int brick = brickwork.first_at(window.start); brick < brickwork.last_at(window.end); ++brick)
            bricks.push_back(keyframe(std::min(brick, brickwork.keyframes - 1)));
        const cv::Mat tile = retarget_tile(brickwork, bricks, span, neighbours, settings, run);
        const bool is_last = i + 1 == spans.size();
        const int finished = is_last ? tile.cols : tile.cols - tile_overlap;
        neighbours.left = tile.colRange(finished, tile.cols).clone();
        sink(tile.colRange(0, finished), {.tiles = i + 1, .border = neighbours.left});
    }
}

}  // namespace vitrine::analyzer
