#include "analyzer/tapestry/weave/strip_zoom.hpp"

#include <utility>

namespace vitrine::analyzer {

namespace {

void append(cv::Mat& strip, const cv::Mat& columns) {
    if (strip.empty())
        strip = columns.clone();
    else
        cv::hconcat(strip, columns, strip);
}

}  // namespace

LevelPair woven_pair(const Film& film, const std::vector<Keyframes>& levels, const RetargetSettings& settings,
                     const RunTasks& run) {
    LevelPair pair{.index = {.duration = film.duration, .levels = {}}, .coarse = {}, .fine = {}};
    pair.index.tile_width = tile_file_width;
    pair.index.brick_width = film.candidates->brick().width;
    for (const std::size_t level : {0U, 1U}) {
        const Keyframes& keyframes = levels[level];
        pair.index.height = tapestry_height(brickwork_of(keyframes, film.candidates->brick()));
        pair.index.levels.push_back(level_of(keyframes, *film.candidates));
        (level == 0 ? pair.coarse : pair.fine) = woven_strip(film, keyframes, settings, run);
    }
    return pair;
}

StripZoom::StripZoom(const LevelPair& pair, const RunTasks& run) {
    ZoomFlow flow(pair.index, 1);
    for (const ZoomFlow::Part& part : flow.parts()) {
        Islands islands =
            flow.match(part, pair.coarse.colRange(part.coarse), pair.fine.colRange(part.fine), run);
        parts_.push_back(
            zoom_part(pair.index, 1, part, {.coarse = pair.coarse, .fine = pair.fine}, std::move(islands)));
    }
    flow.fill();
    warps_ = std::make_unique<ZoomWarps>(flow, pair.index, 1);
}

ZoomPictures StripZoom::synthesised(const ZoomRules& rules, const RunTasks& run) const {
    ZoomPictures strips;
    ZoomPictures left;
    for (const ZoomPart& part : parts_) {
        const ZoomPictures pictures = synthesised_zoom(part, *warps_, left, rules, run);
        left.clear();
        for (const cv::Mat& picture : pictures)
            left.push_back(picture.colRange(picture.cols - part.overlap, picture.cols));
        join(part, pictures, strips);
    }
    return strips;
}

ZoomPictures StripZoom::bent(int between) const {
    ZoomPictures strips;
    for (const ZoomPart& part : parts_)
        join(part, bent_zoom(part, *warps_, between), strips);
    return strips;
}

void StripZoom::join(const ZoomPart& part, const ZoomPictures& pictures, ZoomPictures& strips) const {
    const bool is_last = &part == &parts_.back();
    strips.resize(pictures.size());
    for (std::size_t i = 0; i < pictures.size(); ++i)
        append(strips[i], pictures[i].colRange(0, pictures[i].cols - (is_last ? 0 : part.overlap)));
}

}  // namespace vitrine::analyzer
