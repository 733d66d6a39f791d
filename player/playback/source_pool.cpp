#include "player/playback/source_pool.hpp"

#include "player/scene/stored_request.hpp"

#include <unistd.h>

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
        Playing& known = playing->second;
        known.request.width = request.width;
        known.request.height = request.height;
        const ShotRequest read = known.is_stored ? *stored_request(known.request) : known.request;
        known.source->resize(read.width, read.height);
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
            Playing& playing = playing_[request.source];
            playing.request = request;
            start(playing, true);
        } catch (const std::exception& error) {
            playing_.erase(request.source);
            events.push_back({.source = request.source, .failure = error.what()});
        }
    }
}

/// What the store has is preferred; it may have lost it since.
void SourcePool::start(Playing& playing, bool may_be_stored) {
    const std::optional<ShotRequest> stored = stored_request(playing.request);
    const std::string copy = stored ? places_.store + "/" + stored->path : "";
    playing.is_stored = may_be_stored && stored && ::access(copy.c_str(), R_OK) == 0;
    playing.source = playing.is_stored
                         ? std::make_unique<ShotSource>(copy, *stored, background_)
                         : std::make_unique<ShotSource>(places_.media + "/" + playing.request.path,
                                                        playing.request, background_);
}

void SourcePool::tell(SourceId id, Playing& playing, std::vector<SourceEvent>& events) {
    if (!playing.is_told_ready && playing.source->is_ready()) {
        playing.is_told_ready = true;
        events.push_back({.source = id, .unstored = playing.is_stored ? "" : playing.request.path});
    }
    if (playing.is_told_failed) return;
    if (auto failure = playing.source->failure()) {
        if (playing.is_stored && !playing.is_told_ready) {  // damaged: the file itself may be sound
            ending_.push_back(std::move(playing.source));
            return start(playing, false);
        }
        playing.is_told_failed = true;
        events.push_back({.source = id, .failure = std::move(failure)});
    }
}

}  // namespace vitrine
