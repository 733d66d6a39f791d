#include "analyzer/watch/film_growth.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

FilmGrowth FilmGrowth::published(const MediaRecord& record) {
    FilmGrowth growth(record);
    growth.published_ = record.shots.size();
    return growth;
}

void FilmGrowth::begin_analysis(const MediaRecord& file) {
    const bool is_same = record_.bytes == file.bytes && record_.mtime_ns == file.mtime_ns;
    if (!is_same) published_ = 0;
    is_changed_ = false;
    record_ = file;
}

void FilmGrowth::add_shots(const MediaRecord& part) {
    std::vector<Shot> shots = std::move(record_.shots);
    for (const Shot& shot : part.shots) {
        const auto same = std::find_if(shots.begin(), shots.end(),
                                       [&](const Shot& known) { return known.begin == shot.begin; });
        is_changed_ = is_changed_ || same != shots.end();
        if (same != shots.end())
            *same = shot;
        else
            shots.push_back(shot);
    }
    record_ = part;
    record_.shots = std::move(shots);
}

std::optional<MediaRecord> FilmGrowth::take_news() {
    const std::size_t shots = record_.shots.size();
    const bool has_news = shots > published_ || (is_changed_ && shots == published_);
    if (!has_news) return std::nullopt;
    published_ = shots;
    is_changed_ = false;
    return record_;
}

}  // namespace vitrine::analyzer
