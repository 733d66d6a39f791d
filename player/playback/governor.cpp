#include "player/playback/governor.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double overload = 0.05;  // share of the due pictures that are late
constexpr double calm = 0.005;
constexpr int settling_time = 2;   // periods until a change takes effect
constexpr int probation = 6;       // periods without lateness after a step up: then the step was right
constexpr int max_patience = 512;  // periods
constexpr double min_salience = 1e-3;

Detail below(Detail detail) {
    return static_cast<Detail>(static_cast<int>(detail) + 1);
}

Detail above(Detail detail) {
    return static_cast<Detail>(static_cast<int>(detail) - 1);
}

double lateness(std::span<const FilmLoad> films) {
    int due = 0;
    int late = 0;
    for (const FilmLoad& film : films) {
        due += film.due;
        late += film.late;
    }
    return due > 0 ? static_cast<double>(late) / due : 0;
}

/// The film's cost in proportion to its share of the screen.
double burden(const FilmLoad& film) {
    return film.cost / std::max(film.salience, min_salience);
}

}  // namespace

void FilmMeter::note_shown(double share, std::chrono::nanoseconds time) {
    if (shown_ != time) salience_ = 0;
    salience_ += share;
    shown_ = time;
}

FilmLoad FilmMeter::measure(SourceId source, const ShotCounts& counts, std::chrono::nanoseconds passed) {
    const ShotCounts before = std::exchange(counts_, counts);
    return {.source = source,
            .cost = std::chrono::duration<double>(counts.spent - before.spent) / passed,
            .salience = salience_,
            .due = static_cast<int>(counts.due - before.due),
            .late = static_cast<int>(counts.late - before.late)};
}

Detail Governor::detail(SourceId source) const {
    const auto found = details_.find(source);
    return found == details_.end() ? Detail::all : found->second;
}

std::optional<Governor::Change> Governor::judge(std::span<const FilmLoad> films) {
    forget_all_but(films);
    if (settling_ > 0) {
        --settling_;
        return std::nullopt;
    }
    const double late = lateness(films);
    if (late > overload) {
        calm_ = 0;
        return step_down(films);
    }
    calm_ = late <= calm ? calm_ + 1 : 0;
    if (tried_ && calm_ >= probation) tried_.reset();
    return calm_ >= patience_ ? step_up() : std::nullopt;
}

void Governor::forget_all_but(std::span<const FilmLoad> films) {
    const auto is_gone = [&](SourceId source) {
        return std::ranges::none_of(films, [&](const FilmLoad& film) { return film.source == source; });
    };
    std::erase_if(details_, [&](const auto& entry) { return is_gone(entry.first); });
    std::erase_if(steps_, is_gone);
    if (tried_ && is_gone(*tried_)) tried_.reset();
    if (steps_.empty() && calm_ >= max_patience) patience_ = min_patience;  // the load has changed since
}

std::optional<Governor::Change> Governor::step_down(std::span<const FilmLoad> films) {
    SourceId source = 0;
    if (tried_) {  // the step up came too early: undo it and wait longer
        source = *tried_;
        patience_ = std::min(2 * patience_, max_patience);
        tried_.reset();
    } else {
        const FilmLoad* costliest = nullptr;
        for (const FilmLoad& film : films) {
            if (detail(film.source) == Detail::still) continue;
            if (costliest == nullptr || burden(film) > burden(*costliest)) costliest = &film;
        }
        if (costliest == nullptr) return std::nullopt;
        source = costliest->source;
    }
    const Detail lower = below(detail(source));
    details_[source] = lower;
    steps_.push_back(source);
    settling_ = settling_time;
    return Change{source, lower};
}

std::optional<Governor::Change> Governor::step_up() {
    if (steps_.empty()) return std::nullopt;
    const SourceId source = steps_.back();
    steps_.pop_back();
    const Detail higher = above(detail(source));
    details_[source] = higher;
    if (higher == Detail::all) details_.erase(source);
    tried_ = source;
    calm_ = 0;
    settling_ = settling_time;
    return Change{source, higher};
}

}  // namespace vitrine::player
