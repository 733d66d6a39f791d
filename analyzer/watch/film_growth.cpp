#include "analyzer/watch/film_growth.hpp"

#include <algorithm>

namespace vitrine::analyzer {

void GrowingRecords::known(const MediaRecord& record) {
    growths_[record.path] = {.record = record, .published = record.shots.size()};
}

void GrowingRecords::begin(const MediaRecord& file) {
    Growth& growth = growths_[file.path];
    const bool is_same = growth.record.bytes == file.bytes && growth.record.mtime_ns == file.mtime_ns;
    growth = {.record = file, .published = is_same ? growth.published : 0};
}

void GrowingRecords::add(const MediaRecord& part) {
    Growth& growth = growths_[part.path];
    std::vector<Shot> shots = std::move(growth.record.shots);
    for (const Shot& shot : part.shots) {
        const auto same = std::find_if(shots.begin(), shots.end(),
                                       [&](const Shot& known) { return known.begin == shot.begin; });
        growth.is_changed = growth.is_changed || same != shots.end();
        if (same != shots.end())
            *same = shot;
        else
            shots.push_back(shot);
    }
    growth.record = part;
    growth.record.shots = std::move(shots);
}

bool GrowingRecords::says_more(const Growth& growth) {
    const std::size_t shots = growth.record.shots.size();
    return shots > growth.published || (growth.is_changed && shots == growth.published);
}

std::vector<MediaRecord> GrowingRecords::take_news() {
    std::vector<MediaRecord> news;
    for (auto& [path, growth] : growths_) {
        if (!says_more(growth)) continue;
        growth.published = growth.record.shots.size();
        growth.is_changed = false;
        news.push_back(growth.record);
    }
    return news;
}

bool GrowingRecords::has_news() const {
    return std::any_of(growths_.begin(), growths_.end(),
                       [](const auto& growth) { return says_more(growth.second); });
}

}  // namespace vitrine::analyzer
