#include "player/playback/source_pool.hpp"

#include "player/scene/stored_request.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds judging_period = 1s;
constexpr double least_cost = 0.01;                         // cores, of a film that works
constexpr int most_tries = 3;                               // to go over to a clip
constexpr std::chrono::nanoseconds preparing_time = 500ms;  // until it is ready
constexpr std::chrono::nanoseconds rebuild_time = 300ms;    // until a film built anew plays

/// The part of the screen that an item covers, in [0, 1].
double share_of_screen(const DrawItem& item, Vec2 canvas) {
    if (!item.cell) return 0;
    double area = 0;
    for (const auto& [a, b, c] : item.cell->triangles)
        area += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    return std::min(1.0, item.alpha * area / (canvas.x * canvas.y));
}

}  // namespace

void SourcePool::request(const ShotRequest& request) {
    const auto playing = playing_.find(request.source);
    if (playing != playing_.end()) {
        Playing& known = playing->second;
        known.request.width = request.width;
        known.request.height = request.height;
        if (!known.is_stored && request.shot.stored != known.request.shot.stored) {
            known.request.shot.stored = request.shot.stored;
            known.tries = most_tries;
        }
        const ShotRequest read = known.is_stored ? *stored_request(known.request) : known.request;
        known.source->resize(read.width, read.height);
        if (known.clip) known.clip->resize(request.width, request.height);
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
    for (auto* held : {&found->second.source, &found->second.clip}) {
        if (!*held) continue;
        (*held)->stop();
        ending_.push_back(std::move(*held));
    }
    playing_.erase(found);
}

std::vector<SourceEvent> SourcePool::update() {
    std::erase_if(ending_, [](const auto& source) { return source->has_ended(); });
    std::vector<SourceEvent> events;
    for (auto& [id, playing] : playing_)
        tell(id, playing, events);
    start_waiting(events);
    read_one_anew();
    prepare_clip();
    return events;
}

void SourcePool::advance(Frame& frame) {
    for (DrawItem& item : frame.items) {
        const auto found = playing_.find(item.source);
        if (found == playing_.end()) continue;
        Playing& playing = found->second;
        playing.local = item.local;
        if (playing.clip && playing.local >= playing.seam) go_over(playing);
        if (std::optional<Sample> sample = playing.source->frame_at(item.local)) {
            playing.sample = std::move(sample);
            playing.slide = playing.source->slide();
        }
        item.slide = playing.slide;
        if (!options_.keeps_time) continue;
        if (playing.seen != frame.time) playing.salience = 0;
        playing.salience += share_of_screen(item, frame.canvas);  // of one that is drawn twice the sum
        playing.seen = frame.time;
        watch(playing, item, frame.time);
    }
    if (options_.keeps_time && frame.time - judged_ >= judging_period) govern(frame.time);
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
        Playing& playing = found->second;
        if (playing.clip && item.local >= playing.seam) playing.clip->wait_until_ready(left);
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
        const auto preparing = std::find_if(playing_.begin(), playing_.end(),
                                            [](const auto& entry) { return entry.second.is_preparing(); });
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
    while (!waiting_.empty() && may_start()) {
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

void SourcePool::read_one_anew() {
    const bool is_reading = std::ranges::any_of(playing_, [](const auto& entry) {
        const Playing& playing = entry.second;
        return playing.request.kind == MediaKind::photo && !playing.is_preparing() &&
               !playing.source->has_ended();
    });
    if (is_reading || !waiting_.empty() || count_preparing() > 0) return;
    const auto next = std::ranges::find_if(playing_, [](const auto& entry) {
        return !entry.second.is_preparing() && entry.second.source->is_outdated();
    });
    if (next != playing_.end()) next->second.source->read_anew();
}

/// One film at a time gets its clip ready for the end of its loop.
void SourcePool::prepare_clip() {
    const auto is_in_turn = [](const auto& entry) {
        const Playing& playing = entry.second;
        return playing.tries > 0 && playing.request.kind == MediaKind::film && playing.is_told_ready &&
               !playing.given_up;
    };
    if (std::ranges::any_of(playing_, [](const auto& entry) { return entry.second.clip != nullptr; })) return;
    const auto next = std::ranges::find_if(playing_, is_in_turn);
    if (next == playing_.end()) return;
    Playing& playing = next->second;
    --playing.tries;
    const std::optional<ShotRequest> stored = stored_request(playing.request);
    const std::string copy = stored ? places_.store + "/" + stored->path : "";
    if (!stored || ::access(copy.c_str(), R_OK) != 0) return;
    const std::chrono::nanoseconds loop = stored->shot.duration();
    playing.seam = ((playing.local + preparing_time) / loop + 1) * loop;
    playing.clip = std::make_unique<ShotSource>(copy, *stored, options_, playing.seam);
}

/// The seam has come: to the clip, where that is ready; it has the very pictures, so that nothing is seen of
/// it.
void SourcePool::go_over(Playing& playing) {
    const bool is_ready = playing.clip->is_ready() && !playing.given_up;
    std::unique_ptr<ShotSource>& leaving = is_ready ? playing.source : playing.clip;
    leaving->stop();
    if (is_ready) {
        late_of_retired_ += playing.source->late();
        playing.clip->set_detail(playing.source->detail());
        playing.is_stored = true;
        playing.tries = 0;
        playing.due = playing.late = 0;
        playing.spent = {};
    }
    ending_.push_back(std::move(leaving));
    if (is_ready) playing.source = std::move(playing.clip);
    playing.clip.reset();
}

/// What the store has is preferred; it may have lost it since.
void SourcePool::start(Playing& playing, bool may_be_stored, std::chrono::nanoseconds at) {
    if (before_opening_) before_opening_(playing.request.path);
    playing.opened = std::chrono::steady_clock::now();
    const std::optional<ShotRequest> stored = stored_request(playing.request);
    const std::string copy = stored ? places_.store + "/" + stored->path : "";
    playing.is_stored = may_be_stored && stored && ::access(copy.c_str(), R_OK) == 0;
    SourceOptions options = options_;
    if (playing.is_software) options.film.decoders.clear();
    playing.source = playing.is_stored
                         ? std::make_unique<ShotSource>(copy, *stored, options, at)
                         : std::make_unique<ShotSource>(places_.media + "/" + playing.request.path,
                                                        playing.request, options, at);
    playing.due = playing.late = 0;
    playing.spent = {};
}

void SourcePool::watch(Playing& playing, const DrawItem& item, std::chrono::nanoseconds now) {
    if (!playing.is_told_ready || playing.given_up) return;
    switch (playing.watchdog.judge(playing.source->is_starved(), now)) {
    case Watchdog::Verdict::fine:
        return;
    case Watchdog::Verdict::rebuild_in_software:
        playing.is_software = true;
        return rebuild(playing, item.local);
    case Watchdog::Verdict::rebuild:
        return rebuild(playing, item.local);
    case Watchdog::Verdict::give_up:
        playing.source->stop();
        playing.given_up = "the film stopped in its midst, again and again";
        return;
    }
}

/// The picture shown last stays until there is another.
void SourcePool::rebuild(Playing& playing, std::chrono::nanoseconds local) {
    late_of_retired_ += playing.source->late();
    ++rebuilds_;
    const Detail detail = playing.source->detail();
    playing.source->stop();
    ending_.push_back(std::move(playing.source));
    start(playing, playing.is_stored, local + rebuild_time);
    playing.source->set_detail(detail);
}

void SourcePool::govern(std::chrono::nanoseconds now) {
    std::vector<FilmLoad> loads;
    for (auto& [id, playing] : playing_) {
        const bool plays = playing.is_told_ready && !playing.given_up && playing.seen > judged_;
        if (playing.request.kind == MediaKind::photo || !plays) continue;
        const FilmLoad film = load(id, playing, now - judged_);
        const bool stands = playing.source->is_starved() && film.cost < least_cost;  // the watchdog's matter
        if (!stands) loads.push_back(film);
    }
    judged_ = now;
    const std::optional<Governor::Change> change = governor_.judge(loads);
    if (change) playing_.at(change->source).source->set_detail(change->detail);
}

/// What a film cost and gave since this was asked last.
FilmLoad SourcePool::load(SourceId id, Playing& playing, std::chrono::nanoseconds passed) {
    const ShotSource& source = *playing.source;
    const auto spent = source.spent() - std::exchange(playing.spent, source.spent());
    return {.source = id,
            .cost = std::chrono::duration<double>(spent) / passed,
            .salience = playing.salience,
            .due = static_cast<int>(source.due() - std::exchange(playing.due, source.due())),
            .late = static_cast<int>(source.late() - std::exchange(playing.late, source.late()))};
}

FilmsByDetail SourcePool::films() const {
    FilmsByDetail films;
    for (const auto& [id, playing] : playing_) {
        if (playing.request.kind == MediaKind::photo) continue;
        const Detail detail = playing.source->detail();
        ++(detail == Detail::all ? films.all : detail == Detail::still ? films.still : films.fewer);
    }
    return films;
}

void SourcePool::tell(SourceId id, Playing& playing, std::vector<SourceEvent>& events) {
    if (!playing.is_told_ready && playing.source->is_ready()) {
        playing.is_told_ready = true;
        events.push_back({.source = id, .unstored = playing.is_stored ? "" : playing.request.path});
    }
    if (playing.is_told_failed) return;
    if (auto failure = playing.given_up ? playing.given_up : playing.source->failure()) {
        if (playing.is_stored && !playing.is_told_ready) {  // damaged: the file itself may be sound
            ending_.push_back(std::move(playing.source));
            return start(playing, false);
        }
        if (!playing.is_software && !options_.film.decoders.empty() &&
            !playing.given_up) {  // the decoder's fault?
            playing.is_software = true;
            ending_.push_back(std::move(playing.source));
            return start(playing, playing.is_stored);
        }
        playing.is_told_failed = true;
        events.push_back({.source = id, .failure = std::move(failure)});
    }
}

}  // namespace vitrine::player
