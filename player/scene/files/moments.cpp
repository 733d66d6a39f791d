#include "player/scene/files/moments.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::player {

namespace {

using LocalTime = std::chrono::local_time<std::chrono::milliseconds>;

std::string clock_of(LocalTime time) {
    const auto minutes =
        std::chrono::floor<std::chrono::minutes>(time - std::chrono::floor<std::chrono::days>(time));
    return fmt::format("{:02}:{:02}", minutes / std::chrono::hours(1), minutes.count() % 60);
}

std::chrono::local_days day_of(LocalTime time) {
    return std::chrono::floor<std::chrono::days>(time);
}

std::string date_of(std::chrono::local_days day) {
    const std::chrono::year_month_day date(day);
    return fmt::format("{}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

}  // namespace

Moments::Moments(const RecordList& files) : files_(files) {
    std::vector<const MediaRecord*> dated;
    for (const RecordList::Record& file : files_)
        if (file->origin.taken && file->origin.taken->source != TimeSource::file) dated.push_back(file.get());
    std::ranges::stable_sort(dated, {}, [](const MediaRecord* file) { return file->origin.taken->at; });
    for (const MediaRecord* file : dated) {
        const bool goes_on =
            !moments_.empty() &&
            file->origin.taken->at - moments_.back().last->origin.taken->at <= max_moment_pause;
        if (!goes_on) moments_.push_back({.first = file});
        moments_.back().last = file;
        ++moments_.back().files;
        of_[file->path] = moments_.size() - 1;
    }
}

std::string Moments::words_for(const std::string& path) const {
    const auto found = of_.find(path);
    if (found == of_.end()) return {};
    const Moment& moment = moments_[found->second];
    if (moment.files < 2) return {};
    const LocalTime begin = moment.first->origin.taken->local();
    const LocalTime end = moment.last->origin.taken->local();
    const std::string last_day = day_of(end) == day_of(begin) ? "" : date_of(day_of(end)) + " ";
    return fmt::format("taken on {} between {} and {}{}, with {} other{}", date_of(day_of(begin)),
                       clock_of(begin), last_day, clock_of(end), moment.files - 1,
                       moment.files == 2 ? "" : "s");
}

}  // namespace vitrine::player
