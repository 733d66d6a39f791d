#include "analyzer/tapestry/weave/zoom_files.hpp"

#include "analyzer/tapestry/synthesis/zoom_flow.hpp"
#include "base/media/still_picture.hpp"
#include "base/system/atomic_file.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <map>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int max_tile_side = 4096;    // px of a tile
constexpr std::size_t max_tiles = 16;  // tiles in memory

/// Reads a level's strip from its files, a few tiles at a time.
class StripReader {
  public:
    StripReader(const fs::path& directory, const Tapestry& tapestry, std::size_t level)
        : directory_(directory), tapestry_(tapestry), level_(level) {}

    cv::Mat columns(cv::Range range) {
        std::vector<cv::Mat> tiles;
        const int first = range.start / tapestry_.tile_width;
        for (int number = first; number * tapestry_.tile_width < range.end; ++number)
            tiles.push_back(tile(number));
        cv::Mat all;
        cv::hconcat(tiles, all);
        const int shift = first * tapestry_.tile_width;
        return all.colRange(range.start - shift, std::min(all.cols, range.end - shift));
    }

  private:
    cv::Mat tile(int number) {
        if (const auto found = tiles_.find(number); found != tiles_.end()) return found->second;
        const StillPicture picture = load_still((directory_ / tapestry_.tile_name(level_, number)).string(),
                                                max_tile_side, max_tile_side);
        std::vector<std::byte> pixels = picture.pixels;
        cv::Mat bgr;
        cv::cvtColor(cv::Mat(picture.height, picture.width, CV_8UC4, pixels.data()), bgr, cv::COLOR_RGBA2BGR);
        if (tiles_.size() >= max_tiles) tiles_.erase(tiles_.begin());  // the leftmost tile
        tiles_.emplace(number, bgr);
        return bgr;
    }

    const fs::path& directory_;  // both outlive this
    const Tapestry& tapestry_;
    std::size_t level_;
    std::map<int, cv::Mat> tiles_;
};

}  // namespace

double write_zoom(const fs::path& directory, const Tapestry& tapestry, std::size_t finer,
                  const RunTasks& run) {
    ZoomFlow flow(tapestry, finer);
    StripReader coarse(directory, tapestry, finer - 1);
    StripReader fine(directory, tapestry, finer);
    for (const ZoomFlow::Part& part : flow.parts())
        flow.match(part, coarse.columns(part.coarse), fine.columns(part.fine), run);
    flow.fill();
    for (const bool is_to_finer : {true, false}) {
        const std::size_t level = is_to_finer ? finer - 1 : finer;
        for (int tile = 0; tile < tapestry.tiles(level); ++tile)
            replace_file(directory / tapestry.zoom_name(level, tile, is_to_finer),
                         to_bytes(flow.field(tile, is_to_finer)));
    }
    return flow.matched();
}

}  // namespace vitrine::analyzer
