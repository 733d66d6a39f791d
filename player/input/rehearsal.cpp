#include "player/input/rehearsal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr double max_seconds = 1e6;
constexpr auto sampling = 10ms;     // between two places of a moving finger
constexpr auto tap_time = 80ms;     // a tapping finger is down
constexpr auto flick_time = 120ms;  // a flicking finger moves
constexpr auto rest_time = 200ms;   // a dragging finger rests before it is lifted, so that it does not flick
constexpr double min_finger_gap = 120;  // px, in a pinch
constexpr std::array<std::pair<const char*, Key>, 6> keys{{{"left", Key::left},
                                                           {"right", Key::right},
                                                           {"nearer", Key::nearer},
                                                           {"farther", Key::farther},
                                                           {"select", Key::select},
                                                           {"back", Key::back}}};

std::chrono::nanoseconds seconds(double number) {
    if (!(number >= 0 && number <= max_seconds))
        throw std::runtime_error("a time must be from 0 to 1000000 seconds");
    return std::chrono::nanoseconds(std::llround(number * 1e9));
}

std::chrono::nanoseconds time_of(const InputEvent& event) {
    return std::visit([](const auto& one) { return one.time; }, event);
}

Vec2 place(std::istream& words, const char* complaint) {
    Vec2 place;
    if (!(words >> place.x >> place.y)) throw std::runtime_error(complaint);
    return place;
}

double number(std::istream& words, const char* complaint) {
    double number = 0;
    if (!(words >> number)) throw std::runtime_error(complaint);
    return number;
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
    std::stable_sort(touches_.begin(), touches_.end(),
                     [](const InputEvent& a, const InputEvent& b) { return time_of(a) < time_of(b); });
}

void Rehearsal::read_line(const std::string& line) {
    std::istringstream words(line);
    words >> std::ws;
    if (words.eof() || words.peek() == '#') return;
    double at = 0;
    std::string what;
    if (!(words >> at >> what)) throw std::runtime_error("it must begin with a time in seconds and an event");
    const std::chrono::nanoseconds time = seconds(at);
    if (what == "add" || what == "remove") return read_file(words, time, what == "add");
    if (what == "tap" || what == "hold" || what == "drag" || what == "flick")
        return read_stroke(words, time, what);
    if (what == "pinch") return read_pinch(words, time);
    if (what == "wheel") return read_wheel(words, time);
    if (what == "key") return read_key(words, time);
    if (what == "clock") return clocks_.push_back({.time = time, .shows = clock_time(words)});
    throw std::runtime_error(
        "an event is one of add, remove, tap, hold, drag, flick, pinch, wheel, key, clock");
}

void Rehearsal::read_file(std::istream& words, std::chrono::nanoseconds time, bool is_added) {
    words >> std::ws;
    const std::string path(std::istreambuf_iterator<char>(words), {});
    if (path.empty()) throw std::runtime_error("the file is not named");
    files_.push_back({.time = time, .path = path, .is_added = is_added});
}

void Rehearsal::read_stroke(std::istream& words, std::chrono::nanoseconds time, const std::string& what) {
    if (what == "tap") {
        const Vec2 at = place(words, "a tap is somewhere, 'X Y'");
        return add_stroke({.from = at, .to = at, .time = time, .duration = tap_time});
    }
    if (what == "hold") {
        constexpr auto complaint = "a hold is somewhere for how many seconds, 'X Y SECONDS'";
        const Vec2 at = place(words, complaint);
        const auto duration = seconds(number(words, complaint));
        return add_stroke({.from = at, .to = at, .time = time, .duration = duration});
    }
    constexpr auto complaint = "a drag is from where to where in how many seconds, 'X Y X Y SECONDS'";
    const Vec2 from = place(words, complaint);
    const Vec2 to = place(words, complaint);
    if (what == "flick") return add_stroke({.from = from, .to = to, .time = time, .duration = flick_time});
    const auto duration = seconds(number(words, complaint));
    add_stroke({.from = from, .to = to, .time = time, .duration = duration, .rest = rest_time});
}

/// The fingers lie beside each other.
void Rehearsal::read_pinch(std::istream& words, std::chrono::nanoseconds time) {
    constexpr auto complaint =
        "a pinch is about a place, by how much and in how many seconds, 'X Y FACTOR SECONDS'";
    const Vec2 at = place(words, complaint);
    const double factor = number(words, complaint);
    if (!(factor >= 0.01 && factor <= 100)) throw std::runtime_error("a pinch is by 0.01 to 100");
    const std::chrono::nanoseconds duration = seconds(number(words, complaint));
    const Vec2 first{min_finger_gap / 2 * std::max(1.0, 1 / factor), 0};
    const Vec2 last = first * factor;
    Stroke stroke{.from = at - first, .to = at - last, .time = time, .duration = duration, .rest = rest_time};
    add_stroke(stroke);
    stroke.finger = 1;
    stroke.from = at + first;
    stroke.to = at + last;
    add_stroke(stroke);
}

void Rehearsal::read_wheel(std::istream& words, std::chrono::nanoseconds time) {
    constexpr auto complaint = "a wheel turns somewhere by how many notches, 'X Y NOTCHES'";
    const Vec2 at = place(words, complaint);
    touches_.emplace_back(Wheel{.notches = number(words, complaint), .at = at, .time = time});
}

void Rehearsal::read_key(std::istream& words, std::chrono::nanoseconds time) {
    std::string name;
    words >> name;
    for (const auto& [known, key] : keys)
        if (name == known) return void(touches_.emplace_back(KeyPress{.key = key, .time = time}));
    throw std::runtime_error("a key is one of left, right, nearer, farther, select, back");
}

void Rehearsal::add_stroke(const Stroke& stroke) {
    Contact contact{
        .kind = Contact::Kind::down, .finger = stroke.finger, .at = stroke.from, .time = stroke.time};
    touches_.emplace_back(contact);
    contact.kind = Contact::Kind::move;
    const bool moves = stroke.from != stroke.to;
    for (std::chrono::nanoseconds passed = sampling; moves && passed <= stroke.duration; passed += sampling) {
        const double share =
            std::chrono::duration<double>(passed) / std::chrono::duration<double>(stroke.duration);
        contact.at = stroke.from + (stroke.to - stroke.from) * share;
        contact.time = stroke.time + passed;
        touches_.emplace_back(contact);
    }
    contact.at = stroke.to;
    contact.time = stroke.time + stroke.duration;
    if (moves) touches_.emplace_back(contact);
    contact.kind = Contact::Kind::up;
    contact.time += stroke.rest;
    touches_.emplace_back(contact);
}

bool Rehearsal::advance(std::chrono::nanoseconds now) {
    now_ = now;
    const std::size_t before = passed_;
    while (passed_ < files_.size() && files_[passed_].time <= now)
        ++passed_;
    return passed_ != before;
}

bool Rehearsal::is_present(const std::string& path) const {
    bool is_there = true;
    bool is_first = true;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i].path != path) continue;
        if (is_first) is_there = !files_[i].is_added;
        is_first = false;
        if (i < passed_) is_there = files_[i].is_added;
    }
    return is_there;
}

std::optional<std::chrono::local_seconds> Rehearsal::local_time() const {
    std::optional<std::chrono::local_seconds> shows;
    for (const Clock& clock : clocks_)
        if (clock.time <= now_)
            shows = clock.shows + std::chrono::floor<std::chrono::seconds>(now_ - clock.time);
    return shows;
}

std::vector<InputEvent> Rehearsal::next_touches() {
    std::vector<InputEvent> touches;
    for (; touched_ < touches_.size() && time_of(touches_[touched_]) <= now_; ++touched_)
        touches.push_back(touches_[touched_]);
    return touches;
}

}  // namespace vitrine::player
