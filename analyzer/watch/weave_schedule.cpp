#include "analyzer/watch/weave_schedule.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

void WeaveSchedule::request_film(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns,
                                 const std::string& choice) {
    Wish& wish = wishes_[path];
    if (wish.bytes == bytes && wish.mtime_ns == mtime_ns && wish.choice == choice) return;
    wish = {.bytes = bytes, .mtime_ns = mtime_ns, .choice = choice};
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

std::vector<WeaveAction> WeaveSchedule::next_actions(WeaveScope scope) {
    if (!running_.empty()) return next_for_running(scope);
    const auto next = next_wish(scope);
    if (next == wishes_.end()) return {};
    ++next->second.tries;
    running_ = next->first;
    return {{WeaveAction::Kind::start, running_}};
}

/// A child that gives way has not failed: its weaving goes on later.
std::vector<WeaveAction> WeaveSchedule::next_for_running(WeaveScope scope) {
    if (is_stopping_) return {};
    const bool is_in_the_way = scope != WeaveScope::none && gives_way();
    if (is_outdated_ || is_in_the_way) {
        is_stopping_ = true;
        if (const auto wish = wishes_.find(running_); wish != wishes_.end() && !is_outdated_)
            --wish->second.tries;
        return {{WeaveAction::Kind::stop, running_}};
    }
    const bool may_run = scope == WeaveScope::all || (scope == WeaveScope::wanted && running_ == wanted_);
    if (may_run != is_paused_) return {};
    is_paused_ = !may_run;
    return {{may_run ? WeaveAction::Kind::go_on : WeaveAction::Kind::pause, running_}};
}

/// True if a visitor waits for another film than the one that has a child.
bool WeaveSchedule::gives_way() const {
    const auto wanted = wishes_.find(wanted_);
    return wanted != wishes_.end() && wanted_ != running_ && wanted->second.tries < max_tries;
}

WeaveSchedule::Wishes::iterator WeaveSchedule::next_wish(WeaveScope scope) {
    const auto wanted = wishes_.find(wanted_);
    const bool is_wanted = wanted != wishes_.end() && wanted->second.tries < max_tries;
    if (scope != WeaveScope::none && is_wanted) return wanted;
    auto newest = wishes_.end();
    if (scope != WeaveScope::all) return newest;
    for (auto wish = wishes_.begin(); wish != wishes_.end(); ++wish)
        if (wish->second.tries < max_tries &&
            (newest == wishes_.end() || wish->second.rank() > newest->second.rank()))
            newest = wish;
    return newest;
}

bool WeaveSchedule::is_idle() const {
    return running_.empty() &&
           std::ranges::all_of(wishes_, [](const auto& wish) { return wish.second.tries >= max_tries; });
}

}  // namespace vitrine::analyzer
