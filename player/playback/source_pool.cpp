#include "player/playback/source_pool.hpp"

#include <algorithm>
#include <exception>

namespace vitrine::player {

namespace {

constexpr std::chrono::nanoseconds judging_period = std::chrono::seconds(1);
constexpr long max_preparing = 3;      // sources that may prepare their first picture at a time
constexpr std::size_t max_stuck = 32;  // further sources that are stuck or ending; each has a thread

/// The number of preparing shots for which others wait.
long count_preparing(const std::map<SourceId, PlayingShot>& shots) {
    return std::ranges::count_if(
        shots, [](const auto& entry) { return entry.second.is_preparing() && !entry.second.is_stuck(); });
}

/// True if one more source may start. If too many hang, in opening or in ending, no other starts.
bool may_start(const std::map<SourceId, PlayingShot>& playing, std::size_t ending) {
    const auto stuck =
        std::ranges::count_if(playing, [](const auto& entry) { return entry.second.is_stuck(); });
    return count_preparing(playing) < max_preparing && static_cast<std::size_t>(stuck) + ending < max_stuck;
}

}  // namespace

std::set<std::string> SourcePool::open_files() const {
    std::set<std::string> paths;
    for (const auto& [id, shot] : playing_)
        paths.insert(shot.request().path);
    return paths;
}

void SourcePool::request(const ShotRequest& request) {
    const auto playing = playing_.find(request.source);
    if (playing != playing_.end()) return playing->second.change_request(request);
    const auto waiting = std::ranges::find(waiting_, request.source, &ShotRequest::source);
    if (waiting != waiting_.end())
        *waiting = request;
    else
        waiting_.push_back(request);
}

void SourcePool::retire(SourceId source) {
    std::erase_if(waiting_, [&](const ShotRequest& request) { return request.source == source; });
    const auto found = playing_.find(source);
    if (found == playing_.end()) return;
    found->second.retire();
    playing_.erase(found);
}

std::vector<SourceId> SourcePool::retire_all() {
    std::vector<SourceId> all;
    for (const auto& [id, shot] : playing_)
        all.push_back(id);
    for (const SourceId id : all)
        retire(id);
    waiting_.clear();
    return all;
}

std::vector<SourceEvent> SourcePool::update() {
    std::erase_if(pool_.ending, [](const auto& source) { return source->has_ended(); });
    std::vector<SourceEvent> events;
    for (auto& [id, shot] : playing_)
        shot.collect_events(events);
    start_waiting(events);
    read_one_photo_anew();
    open_one_clip();
    return listeners_.deliver(std::move(events));
}

void SourcePool::advance(const Frame& frame) {
    for (const DrawItem& item : frame.items) {
        const auto found = playing_.find(item.source);
        if (found != playing_.end()) found->second.advance(item, frame);
    }
    if (pool_.options.keeps_time && frame.time - judged_ >= judging_period) govern(frame.time);
}

std::optional<Sample> SourcePool::sample(SourceId source) const {
    const auto found = playing_.find(source);
    return found == playing_.end() ? std::nullopt : found->second.sample();
}

bool SourcePool::wait_for(const Frame& frame, std::chrono::nanoseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    bool is_exact = true;
    for (const DrawItem& item : frame.items) {
        const auto found = playing_.find(item.source);
        if (found == playing_.end()) continue;
        is_exact =
            found->second.wait_for(item.local, deadline - std::chrono::steady_clock::now()) && is_exact;
    }
    return is_exact;
}

std::vector<SourceEvent> SourcePool::wait_until_ready(std::chrono::nanoseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    std::vector<SourceEvent> events;
    while (true) {
        const std::vector<SourceEvent> news = update();
        events.insert(events.end(), news.begin(), news.end());
        const auto preparing =
            std::ranges::find_if(playing_, [](const auto& entry) { return entry.second.is_preparing(); });
        if (preparing == playing_.end() && waiting_.empty()) return events;
        const auto left = deadline - std::chrono::steady_clock::now();
        if (left.count() <= 0) return events;
        if (preparing != playing_.end()) preparing->second.source().wait_until_ready(left);
    }
}

std::uint64_t SourcePool::late() const {
    std::uint64_t late = pool_.late;
    for (const auto& [id, shot] : playing_)
        late += shot.source().counts().late;
    return late;
}

std::vector<SourceState> SourcePool::states() const {
    std::vector<SourceState> states;
    for (const auto& [id, shot] : playing_)
        states.push_back(shot.state());
    return states;
}

std::size_t SourcePool::queue() const {
    const auto preparing =
        std::ranges::count_if(playing_, [](const auto& entry) { return entry.second.is_preparing(); });
    return waiting_.size() + static_cast<std::size_t>(preparing);
}

void SourcePool::start_waiting(std::vector<SourceEvent>& events) {
    while (!waiting_.empty() && may_start(playing_, pool_.ending.size())) {
        const ShotRequest request = std::move(waiting_.front());
        waiting_.pop_front();
        try {
            playing_.try_emplace(request.source, request, pool_);
        } catch (const std::exception& error) {
            events.push_back({.source = request.source, .failure = error.what()});
        }
    }
}

void SourcePool::read_one_photo_anew() {
    const bool is_reading = std::ranges::any_of(playing_, [](const auto& entry) {
        const PlayingShot& shot = entry.second;
        return shot.request().kind == MediaKind::photo && !shot.is_preparing() && !shot.source().has_ended();
    });
    if (is_reading || !waiting_.empty() || count_preparing(playing_) > 0) return;
    const auto next = std::ranges::find_if(playing_, [](const auto& entry) {
        return !entry.second.is_preparing() && entry.second.source().is_outdated();
    });
    if (next != playing_.end()) next->second.source().read_photo();
}

/// Opens the clip of one film at a time, for the end of the film's loop.
void SourcePool::open_one_clip() {
    if (std::ranges::any_of(playing_, [](const auto& entry) { return entry.second.has_clip(); })) return;
    const auto next =
        std::ranges::find_if(playing_, [](const auto& entry) { return entry.second.is_clip_wanted(); });
    if (next != playing_.end()) next->second.open_clip();
}

void SourcePool::govern(std::chrono::nanoseconds now) {
    std::vector<FilmLoad> loads;
    for (auto& [id, shot] : playing_)
        if (const std::optional<FilmLoad> load = shot.measure_load(judged_, now)) loads.push_back(*load);
    judged_ = now;
    const std::optional<Governor::Change> change = governor_.judge(loads);
    if (change) playing_.at(change->source).source().set_detail(change->detail);
}

}  // namespace vitrine::player
