#include "analyzer/watch/weave_schedule.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

void WeaveSchedule::request_film(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns) {
    Wish& wish = wishes_[path];
    if (wish.bytes == bytes && wish.mtime_ns == mtime_ns) return;
    wish = {.bytes = bytes, .mtime_ns = mtime_ns};
    if (running_ == path) is_outdated_ = true;
}

void WeaveSchedule::forget_film(const std::string& path) {
    wishes_.erase(path);
    if (running_ == path) is_outdated_ = true;
}

void WeaveSchedule::finish_weaving(const std::string& path, bool is_woven) {
    running_.clear();
    is_paused_ = is_stopping_ = false;
    if (std::exchange(is_outdated_, false)) return;
    if (is_woven) wishes_.erase(path);
}

std::vector<WeaveAction> WeaveSchedule::next_actions(bool is_free) {
    if (!running_.empty()) {
        if (is_stopping_) return {};
        if (is_outdated_) {
            is_stopping_ = true;
            return {{WeaveAction::Kind::stop, running_}};
        }
        if (is_free != is_paused_) return {};
        is_paused_ = !is_free;
        return {{is_free ? WeaveAction::Kind::go_on : WeaveAction::Kind::pause, running_}};
    }
    if (!is_free) return {};
    auto newest = wishes_.end();
    for (auto wish = wishes_.begin(); wish != wishes_.end(); ++wish)
        if (wish->second.tries < max_tries &&
            (newest == wishes_.end() || wish->second.mtime_ns > newest->second.mtime_ns))
            newest = wish;
    if (newest == wishes_.end()) return {};
    ++newest->second.tries;
    running_ = newest->first;
    return {{WeaveAction::Kind::start, running_}};
}

bool WeaveSchedule::is_idle() const {
    return running_.empty() &&
           std::ranges::all_of(wishes_, [](const auto& wish) { return wish.second.tries >= max_tries; });
}

}  // namespace vitrine::analyzer
