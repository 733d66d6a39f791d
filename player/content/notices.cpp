#include "player/content/notices.hpp"

#include "base/state/path_text.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <system_error>
#include <utility>

namespace vitrine::player {

Notices::Notices(std::filesystem::path note) : file_(std::move(note)) {
    read();
}

bool Notices::set_files(const RecordList& files, const CanBeShown& can_be_shown, Time now) {
    notices_.clear();
    std::set<std::string> there;
    const std::string first = "!", end = "\"";  // the character behind '!'
    for (const RecordList::Record& file : files.between(first, end)) {
        const auto notice = notice_named(file->path);
        if (!notice) continue;
        there.insert(notice->entry);
        if (can_be_shown(*file)) notices_.emplace(notice->entry, *notice);
    }
    const auto before = since_;
    std::erase_if(since_, [&](const auto& one) { return !there.contains(one.first); });
    for (const auto& [entry, notice] : notices_)
        since_.emplace(entry, now);
    if (since_ != before) write();
    return look(now);
}

bool Notices::look(Time now) {
    now_ = now;
    std::string active;
    Time latest{};
    for (auto& [entry, begin] : since_) {
        if (begin > now) begin = now;  // the clock was set back
        const auto notice = notices_.find(entry);
        if (notice == notices_.end()) continue;
        const bool is_over = notice->second.length && now - begin >= *notice->second.length;
        if (is_over || (!active.empty() && begin < latest)) continue;
        active = entry;
        latest = begin;
    }
    if (active == active_) return false;
    log::info("notice: {}", active.empty() ? "none any more" : fmt::format("'{}' covers the walls", active));
    active_ = std::move(active);
    return true;
}

bool Notices::is_over(const std::string& path) const {
    const auto notice = notice_named(path);
    if (!notice || !notice->length) return false;
    const auto begin = since_.find(notice->entry);
    return begin != since_.end() && now_ - begin->second >= *notice->length;
}

bool Notices::is_covered(const std::string& path) const {
    if (active_.empty()) return false;
    const auto notice = notice_named(path);
    return !notice || notice->entry != active_;
}

/// A line a notice: the seconds since 1970 at which it began, and its name in hex digits.
void Notices::read() {
    std::error_code missing;
    if (file_.empty() || !std::filesystem::exists(file_, missing)) return;
    try {
        std::istringstream lines(read_file(file_));
        long long seconds = 0;
        std::string name;
        while (lines >> seconds >> name)
            since_.emplace(from_hex(name), Time(std::chrono::seconds(seconds)));
    } catch (const std::runtime_error& error) {  // the file is damaged
        log::warning("'{}' unreadable, ignoring: {}", file_.string(), error.what());
    }
}

void Notices::write() const {
    if (file_.empty()) return;
    std::string text;
    for (const auto& [entry, begin] : since_)
        text += fmt::format("{} {}\n", begin.time_since_epoch().count(), to_hex(entry));
    try {
        replace_file(file_, text);
    } catch (const std::system_error& error) {
        log::warning("the begin of notices cannot be noted: {}", error.what());
    }
}

}  // namespace vitrine::player
