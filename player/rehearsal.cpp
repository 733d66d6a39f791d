#include "player/rehearsal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace vitrine {

namespace {

constexpr double most_seconds = 1e6;

std::chrono::nanoseconds seconds(double number) {
    if (!(number >= 0 && number <= most_seconds))
        throw std::runtime_error("a time must be from 0 to 1000000 seconds");
    return std::chrono::nanoseconds(static_cast<std::int64_t>(number * 1e9));
}

std::chrono::local_seconds clock_time(std::istringstream& words) {
    std::tm civil{};
    words >> std::get_time(&civil, "%Y-%m-%d %H:%M:%S");
    const std::chrono::year_month_day day{std::chrono::year(civil.tm_year + 1900),
                                          std::chrono::month(static_cast<unsigned>(civil.tm_mon + 1)),
                                          std::chrono::day(static_cast<unsigned>(civil.tm_mday))};
    if (words.fail() || !day.ok()) throw std::runtime_error("a clock shows 'YYYY-MM-DD HH:MM:SS'");
    return std::chrono::local_days(day) + std::chrono::hours(civil.tm_hour) +
           std::chrono::minutes(civil.tm_min) + std::chrono::seconds(civil.tm_sec);
}

}  // namespace

Rehearsal::Rehearsal(const std::string& script) {
    std::istringstream lines(script);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        try {
            read_line(line);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("line {} of the rehearsal, '{}': {}", number, line, error.what()));
        }
    }
    std::stable_sort(files_.begin(), files_.end(),
                     [](const FileEvent& a, const FileEvent& b) { return a.time < b.time; });
}

void Rehearsal::read_line(const std::string& line) {
    std::istringstream words(line);
    words >> std::ws;
    if (words.eof() || words.peek() == '#') return;
    double time = 0;
    std::string what;
    if (!(words >> time >> what))
        throw std::runtime_error("it must begin with a time in seconds and an event");
    if (what == "add" || what == "remove") {
        words >> std::ws;
        const std::string path(std::istreambuf_iterator<char>(words), {});
        if (path.empty()) throw std::runtime_error("the file is not named");
        files_.push_back({.time = seconds(time), .path = path, .is_added = what == "add"});
        return;
    }
    if (what == "clock") return clocks_.push_back({.time = seconds(time), .shows = clock_time(words)});
    if (what != "drag") throw std::runtime_error("an event is one of add, remove, drag, clock");
    Drag drag{.time = seconds(time)};
    double duration = 0;
    if (!(words >> drag.from.x >> drag.from.y >> drag.to.x >> drag.to.y >> duration))
        throw std::runtime_error("a drag is from where to where in how many seconds, 'X Y X Y SECONDS'");
    drag.duration = seconds(duration);
    drags_.push_back(drag);
}

bool Rehearsal::advance(std::chrono::nanoseconds now) {
    now_ = now;
    const std::size_t before = passed_;
    while (passed_ < files_.size() && files_[passed_].time <= now)
        ++passed_;
    return passed_ != before;
}

std::vector<MediaRecord> Rehearsal::present(std::span<const MediaRecord> records) const {
    std::vector<MediaRecord> present;
    const auto is_present = [&](const MediaRecord& record) {
        bool is_there = true;
        bool is_first = true;
        for (std::size_t i = 0; i < files_.size(); ++i) {
            if (files_[i].path != record.path) continue;
            if (is_first) is_there = !files_[i].is_added;
            is_first = false;
            if (i < passed_) is_there = files_[i].is_added;
        }
        return is_there;
    };
    std::copy_if(records.begin(), records.end(), std::back_inserter(present), is_present);
    return present;
}

std::optional<std::chrono::local_seconds> Rehearsal::local_time() const {
    std::optional<std::chrono::local_seconds> shows;
    for (const Clock& clock : clocks_)
        if (clock.time <= now_)
            shows = clock.shows + std::chrono::floor<std::chrono::seconds>(now_ - clock.time);
    return shows;
}

std::optional<Vec2> Rehearsal::finger() const {
    for (const Drag& drag : drags_) {
        const std::chrono::nanoseconds passed = now_ - drag.time;
        if (passed.count() < 0 || passed > drag.duration) continue;
        const double share = drag.duration.count() > 0 ? std::chrono::duration<double>(passed) /
                                                             std::chrono::duration<double>(drag.duration)
                                                       : 1;
        return drag.from + (drag.to - drag.from) * share;
    }
    return std::nullopt;
}

}  // namespace vitrine
