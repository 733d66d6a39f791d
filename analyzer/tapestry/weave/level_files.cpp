#include "analyzer/tapestry/weave/level_files.hpp"

#include "analyzer/tapestry/weave/picture_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

// A note is a picture, rest-TILES.png: the columns that are in no tile file yet, then the border that the
// next tile of the weaving begins with. TILES, the number of woven tiles, tells where the columns belong.

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t tiles_a_note = 4;  // a few seconds of work
constexpr std::string_view note_begin = "rest-";

std::optional<std::size_t> tiles_of_note(const std::string& name) {
    if (!name.starts_with(note_begin) || !name.ends_with(".png")) return std::nullopt;
    std::size_t tiles = 0;
    const auto [stop, error] =
        std::from_chars(name.data() + note_begin.size(), name.data() + name.size(), tiles);
    if (error != std::errc() || std::string_view(stop) != ".png") return std::nullopt;
    return tiles;
}

}  // namespace

LevelFiles::LevelFiles(const fs::path& directory, const Tapestry& tapestry, std::size_t level,
                       const Brickwork& brickwork)
    : directory_(directory),
      tapestry_(tapestry),
      level_(level),
      spans_(tile_spans(brickwork.width(), brickwork.brick.height)) {
    fs::create_directories(folder());
    for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
        const auto tiles = tiles_of_note(entry.path().filename().string());
        if (!tiles || *tiles == 0 || *tiles >= spans_.size() || *tiles < done_.tiles) continue;
        try {
            go_on_from(*tiles, read_png(entry.path()));
            note_ = entry.path();
        } catch (const std::runtime_error&) {  // loading one record: a crash left it, it is woven again
            continue;
        }
    }
}

void LevelFiles::go_on_from(std::size_t tiles, const cv::Mat& rest) {
    const int columns = spans_[tiles].from % tapestry_.tile_width;
    const int overlap = spans_[tiles - 1].to - spans_[tiles].from;
    if (rest.size() != cv::Size(columns + overlap, tapestry_.height))
        throw std::runtime_error("a note of another size");
    done_ = {.tiles = tiles, .border = rest.colRange(columns, rest.cols).clone()};
    pending_ = columns > 0 ? rest.colRange(0, columns).clone() : cv::Mat();
    next_ = spans_[tiles].from / tapestry_.tile_width;
}

fs::path LevelFiles::folder() const {
    return (directory_ / tapestry_.tile_name(level_, 0)).parent_path();
}

fs::path LevelFiles::note(std::size_t tiles) const {
    return folder() / fmt::format("{}{}.png", note_begin, tiles);
}

void LevelFiles::add(const cv::Mat& columns, const WovenSoFar& done) {
    if (pending_.empty())
        pending_ = columns.clone();
    else
        cv::hconcat(pending_, columns, pending_);
    while (pending_.cols >= tapestry_.tile_width) {
        write(pending_.colRange(0, tapestry_.tile_width));
        pending_ = pending_.colRange(tapestry_.tile_width, pending_.cols).clone();
    }
    if (done.tiles % tiles_a_note != 0 || done.tiles >= spans_.size()) return;
    cv::Mat rest = done.border;
    if (!pending_.empty()) cv::hconcat(pending_, done.border, rest);
    const fs::path before = std::exchange(note_, note(done.tiles));
    write_png(note_, rest);
    std::error_code ignored;  // the newer one counts
    if (!before.empty()) fs::remove(before, ignored);
}

void LevelFiles::finish() {
    if (!pending_.empty()) write(pending_);
}

void LevelFiles::remove_note() {
    std::error_code ignored;  // it is small, and goes with the level
    if (!note_.empty()) fs::remove(note_, ignored);
}

void LevelFiles::write(const cv::Mat& tile) {
    write_jpeg(directory_ / tapestry_.tile_name(level_, next_++), tile.clone());
}

}  // namespace vitrine::analyzer
