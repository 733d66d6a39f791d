#include "player/playback/source_pool.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace vitrine {

namespace {

constexpr long most_at_once = 3;  // sources that are read to their first picture

}  // namespace

void SourcePool::request(const ShotRequest& request) {
    const auto playing = playing_.find(request.source);
    if (playing != playing_.end()) {
        playing->second.source->resize(request.width, request.height);
        return;
    }
    const auto waiting = std::find_if(waiting_.begin(), waiting_.end(), [&](const ShotRequest& other) {
        return other.source == request.source;
    });
    if (waiting != waiting_.end())
        *waiting = request;
    else
        waiting_.push_back(request);
}

void SourcePool::retire(SourceId source) {
    std::erase_if(waiting_, [&](const ShotRequest& request) { return request.source == source; });
    const auto found = playing_.find(source);
    if (found == playing_.end()) return;
    late_of_retired_ += found->second.source->late();
    found->second.source->stop();
    ending_.push_back(std::move(found->second.source));
    playing_.erase(found);
}

std::vector<SourceEvent> SourcePool::update() {
    std::erase_if(ending_, [](const auto& source) { return source->has_ended(); });
    std::vector<SourceEvent> events;
    for (auto& [id, playing] : playing_)
        tell(id, playing, events);
    start_waiting(events);
    return events;
}

void SourcePool::advance(Frame& frame) {
    for (DrawItem& item : frame.items) {
        const auto found = playing_.find(item.source);
        if (found == playing_.end()) continue;
        found->second.sample = found->second.source->frame_at(item.local);
        item.slide = found->second.source->slide();
    }
}

std::optional<Sample> SourcePool::sample(SourceId source) const {
    const auto found = playing_.find(source);
    return found == playing_.end() ? std::nullopt : found->second.sample;
}

bool SourcePool::wait_for(const Frame& frame, std::chrono::nanoseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    bool is_exact = true;
    for (const DrawItem& item : frame.items) {
        const auto found = playing_.find(item.source);
        if (found == playing_.end() || found->second.source->failure()) continue;
        const auto left = deadline - std::chrono::steady_clock::now();
        is_exact = found->second.source->wait_for(item.local, left) && is_exact;
    }
    return is_exact;
}

std::vector<SourceEvent> SourcePool::wait_until_ready(std::chrono::nanoseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    std::vector<SourceEvent> events;
    while (true) {
        const std::vector<SourceEvent> news = update();
        events.insert(events.end(), news.begin(), news.end());
        const auto preparing = std::find_if(playing_.begin(), playing_.end(), [](const auto& entry) {
            return !entry.second.is_told_ready && !entry.second.is_told_failed;
        });
        if (preparing == playing_.end() && waiting_.empty()) return events;
        const auto left = deadline - std::chrono::steady_clock::now();
        if (left.count() <= 0) return events;
        if (preparing != playing_.end()) preparing->second.source->wait_until_ready(left);
    }
}

std::uint64_t SourcePool::late() const {
    std::uint64_t late = late_of_retired_;
    for (const auto& [id, playing] : playing_)
        late += playing.source->late();
    return late;
}

void SourcePool::start_waiting(std::vector<SourceEvent>& events) {
    auto preparing = std::count_if(playing_.begin(), playing_.end(), [](const auto& entry) {
        return !entry.second.is_told_ready && !entry.second.is_told_failed;
    });
    for (; !waiting_.empty() && preparing < most_at_once; ++preparing) {
        const ShotRequest request = std::move(waiting_.front());
        waiting_.pop_front();
        try {
            playing_[request.source].source =
                std::make_unique<ShotSource>(root_ + "/" + request.path, request, background_);
        } catch (const std::exception& error) {
            playing_.erase(request.source);
            events.push_back({.source = request.source, .failure = error.what()});
        }
    }
}

void SourcePool::tell(SourceId id, Playing& playing, std::vector<SourceEvent>& events) {
    if (!playing.is_told_ready && playing.source->is_ready()) {
        playing.is_told_ready = true;
        events.push_back({.source = id});
    }
    if (playing.is_told_failed) return;
    if (auto failure = playing.source->failure()) {
        playing.is_told_failed = true;
        events.push_back({.source = id, .failure = std::move(failure)});
    }
}

}  // namespace vitrine
