#include "analyzer/watch/leaving_files.hpp"

#include <algorithm>

namespace vitrine::analyzer {

void LeavingFiles::add(const std::string& path, const FileFacts& facts, bool is_done, Time forget_at) {
    files_[path] = {.facts = facts, .is_done = is_done, .forget_at = forget_at};
}

LeavingFiles::Return LeavingFiles::take_back(const std::string& path, const FileFacts& facts) {
    const auto left = files_.find(path);
    if (left == files_.end()) return {};
    const bool holds = left->second.is_done && is_same_content(left->second.facts, facts);
    files_.erase(left);
    return {.is_recorded = true, .record_holds = holds};
}

std::optional<std::string> LeavingFiles::take_renamed(const FileFacts& facts) {
    if (facts.inode == 0) return std::nullopt;
    const auto left = std::find_if(files_.begin(), files_.end(), [&](const auto& candidate) {
        const File& file = candidate.second;
        return file.is_done && file.facts.inode == facts.inode && is_same_content(file.facts, facts);
    });
    if (left == files_.end()) return std::nullopt;
    std::string path = left->first;
    files_.erase(left);
    return path;
}

std::vector<std::string> LeavingFiles::take_expired(Time now) {
    std::vector<std::string> expired;
    std::erase_if(files_, [&](const auto& file) {
        if (file.second.forget_at > now) return false;
        expired.push_back(file.first);
        return true;
    });
    return expired;
}

std::optional<LeavingFiles::Time> LeavingFiles::next_expiry() const {
    std::optional<Time> earliest;
    for (const auto& [path, file] : files_)
        earliest = std::min(earliest.value_or(file.forget_at), file.forget_at);
    return earliest;
}

}  // namespace vitrine::analyzer
