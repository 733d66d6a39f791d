#include "analyzer/watch/leaving_files.hpp"

namespace vitrine::analyzer {

void LeavingFiles::add(const std::string& path, const FileFacts& facts, bool is_done, Time forget_at) {
    if (const auto known = files_.find(path); known != files_.end()) erase(known);
    files_[path] = {.facts = facts, .is_done = is_done, .forget_at = forget_at};
    by_time_.emplace(forget_at, path);
    if (is_done && facts.inode != 0) by_inode_.emplace(facts.inode, path);
}

void LeavingFiles::erase(Files::iterator left) {
    by_time_.erase({left->second.forget_at, left->first});
    by_inode_.erase({left->second.facts.inode, left->first});
    files_.erase(left);
}

LeavingFiles::Return LeavingFiles::take_back(const std::string& path, const FileFacts& facts) {
    const auto left = files_.find(path);
    if (left == files_.end()) return {};
    const bool holds = left->second.is_done && is_same_content(left->second.facts, facts);
    erase(left);
    return {.is_recorded = true, .record_holds = holds};
}

std::optional<std::string> LeavingFiles::take_renamed(const FileFacts& facts) {
    for (auto it = by_inode_.lower_bound({facts.inode, ""});
         it != by_inode_.end() && it->first == facts.inode; ++it) {
        ++compared_;
        std::string path = it->second;
        const auto left = files_.find(path);
        if (!is_same_content(left->second.facts, facts)) continue;
        erase(left);
        return path;
    }
    return std::nullopt;
}

std::vector<std::string> LeavingFiles::take_expired(Time now) {
    std::vector<std::string> expired;
    while (!by_time_.empty() && by_time_.begin()->first <= now) {
        expired.push_back(by_time_.begin()->second);
        erase(files_.find(expired.back()));
    }
    return expired;
}

std::optional<LeavingFiles::Time> LeavingFiles::next_expiry() const {
    if (by_time_.empty()) return std::nullopt;
    return by_time_.begin()->first;
}

}  // namespace vitrine::analyzer
