#include "analyzer/growing_records.hpp"

#include <algorithm>

namespace vitrine {

void GrowingRecords::known(const MediaRecord& record) {
    growths_[record.path] = {.record = record, .published = record.shots.size()};
}

void GrowingRecords::begin(const MediaRecord& file) {
    Growth& growth = growths_[file.path];
    const bool is_same = growth.record.bytes == file.bytes && growth.record.mtime_ns == file.mtime_ns;
    growth = {.record = file, .published = is_same ? growth.published : 0};
}

void GrowingRecords::add(const MediaRecord& part) {
    MediaRecord& record = growths_[part.path].record;
    std::vector<Shot> shots = std::move(record.shots);
    shots.insert(shots.end(), part.shots.begin(), part.shots.end());
    record = part;
    record.shots = std::move(shots);
}

std::vector<MediaRecord> GrowingRecords::take_news() {
    std::vector<MediaRecord> news;
    for (auto& [path, growth] : growths_) {
        if (growth.record.shots.size() <= growth.published) continue;
        growth.published = growth.record.shots.size();
        news.push_back(growth.record);
    }
    return news;
}

bool GrowingRecords::has_news() const {
    return std::any_of(growths_.begin(), growths_.end(), [](const auto& growth) {
        return growth.second.record.shots.size() > growth.second.published;
    });
}

}  // namespace vitrine
