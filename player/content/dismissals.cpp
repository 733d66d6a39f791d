#include "player/content/dismissals.hpp"

#include <utility>

namespace vitrine::player {

std::vector<MediaRecord> Dismissals::filtered(const std::vector<MediaRecord>& records) {
    std::map<std::string, MediaRecord> still;
    std::vector<MediaRecord> left;
    for (const MediaRecord& record : records) {
        const auto found = dismissed_.find(record.path);
        const bool is_same = found != dismissed_.end() && found->second.bytes == record.bytes &&
                             found->second.mtime_ns == record.mtime_ns;
        if (is_same)
            still.insert(*found);
        else
            left.push_back(record);
    }
    dismissed_ = std::move(still);
    return left;
}

std::vector<std::string> Dismissals::paths() const {
    std::vector<std::string> paths;
    for (const auto& [path, record] : dismissed_)
        paths.push_back(path);
    return paths;
}

}  // namespace vitrine::player
