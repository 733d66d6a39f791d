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
constexpr auto sampling = 10ms;     // between two points of a moving finger
constexpr auto tap_time = 80ms;     // length of a tap
constexpr auto flick_time = 120ms;  // length of a flick
constexpr auto rest_time = 200ms;   // a dragging finger rests before it is lifted, so that it does not flick
constexpr double min_finger_gap = 120;  // px, in a pinch
constexpr int max_finger = 99;          // number of a finger that a script moves by itself
constexpr std::array<std::pair<const char*, Key>, 7> keys{{{"left", Key::left},
                                                           {"right", Key::right},
                                                           {"nearer", Key::nearer},
                                                           {"farther", Key::farther},
                                                           {"select", Key::select},
                                                           {"back", Key::back},
                                                           {"undo", Key::undo}}};

std::chrono::nanoseconds seconds(double number) {
    if (!(number >= 0 && number <= max_seconds))
        throw std::runtime_error("a time must be from 0 to 1000000 seconds");
    return std::chrono::nanoseconds(std::llround(number * 1e9));
}

std::chrono::nanoseconds time_of(const InputEvent& event) {
    return std::visit([](const auto& one) { return one.time; }, event);
}

/// The words after the first word of a line.
struct Arguments {
    std::istream& words;
    std::chrono::nanoseconds time{0};  // time of the event
    const char* usage = "";            // the error text for a missing argument
    int finger = 0;                    // number of the line's first finger; a pinch has two

    double number() {
        double number = 0;
        if (!(words >> number)) throw std::runtime_error(usage);
        return number;
    }

    Vec2 place() {
        const double x = number();
        return {x, number()};
    }

    std::chrono::nanoseconds duration() { return seconds(number()); }
};

/// A finger that comes down, moves and is lifted.
struct Stroke {
    int finger = 0;
    Vec2 from;
    Vec2 to;
    std::chrono::nanoseconds time{0};  // time of the first contact
    std::chrono::nanoseconds duration{0};
    std::chrono::nanoseconds rest{0};  // rest before the finger is lifted
};

using Input = std::vector<InputEvent>;

Input contacts(const Stroke& stroke) {
    Input events;
    Contact contact{
        .kind = Contact::Kind::down, .finger = stroke.finger, .at = stroke.from, .time = stroke.time};
    events.emplace_back(contact);
    contact.kind = Contact::Kind::move;
    const bool moves = stroke.from != stroke.to;
    for (std::chrono::nanoseconds passed = sampling; moves && passed <= stroke.duration; passed += sampling) {
        const double share =
            std::chrono::duration<double>(passed) / std::chrono::duration<double>(stroke.duration);
        contact.at = stroke.from + (stroke.to - stroke.from) * share;
        contact.time = stroke.time + passed;
        events.emplace_back(contact);
    }
    contact.at = stroke.to;
    contact.time = stroke.time + stroke.duration;
    if (moves) events.emplace_back(contact);
    contact.kind = Contact::Kind::up;
    contact.time += stroke.rest;
    events.emplace_back(contact);
    return events;
}

Input tap(Arguments& arguments) {
    const Vec2 at = arguments.place();
    return contacts(
        {.finger = arguments.finger, .from = at, .to = at, .time = arguments.time, .duration = tap_time});
}

Input hold(Arguments& arguments) {
    const Vec2 at = arguments.place();
    return contacts({.finger = arguments.finger,
                     .from = at,
                     .to = at,
                     .time = arguments.time,
                     .duration = arguments.duration()});
}

Input drag(Arguments& arguments) {
    const Vec2 from = arguments.place();
    const Vec2 to = arguments.place();
    return contacts({.finger = arguments.finger,
                     .from = from,
                     .to = to,
                     .time = arguments.time,
                     .duration = arguments.duration(),
                     .rest = rest_time});
}

Input flick(Arguments& arguments) {
    const Vec2 from = arguments.place();
    const Vec2 to = arguments.place();
    return contacts(
        {.finger = arguments.finger, .from = from, .to = to, .time = arguments.time, .duration = flick_time});
}

/// Two fingers beside each other; at the end their gap is larger by the factor.
Input pinch(Arguments& arguments) {
    const Vec2 at = arguments.place();
    const double factor = arguments.number();
    if (!(factor >= 0.01 && factor <= 100))
        throw std::runtime_error("the factor of a pinch must be from 0.01 to 100");
    const Vec2 first{min_finger_gap / 2 * std::max(1.0, 1 / factor), 0};
    const Vec2 last = first * factor;
    Stroke stroke{.finger = arguments.finger,
                  .from = at - first,
                  .to = at - last,
                  .time = arguments.time,
                  .duration = arguments.duration(),
                  .rest = rest_time};
    Input events = contacts(stroke);
    ++stroke.finger;
    stroke.from = at + first;
    stroke.to = at + last;
    const Input second = contacts(stroke);
    events.insert(events.end(), second.begin(), second.end());
    return events;
}

Input wheel(Arguments& arguments) {
    const Vec2 at = arguments.place();
    return {Wheel{.notches = arguments.number(), .at = at, .time = arguments.time}};
}

Input key(Arguments& arguments) {
    std::string name;
    arguments.words >> name;
    for (const auto& [known, key] : keys)
        if (name == known) return {KeyPress{.key = key, .time = arguments.time}};
    throw std::runtime_error(arguments.usage);
}

/// One contact of a finger that the script counts itself, so that it can be lost or stay.
template <Contact::Kind kind> Input contact(Arguments& arguments) {
    const double number = arguments.number();
    if (!(number >= 0 && number <= max_finger && number == std::floor(number)))
        throw std::runtime_error(fmt::format("a finger is a number from 0 to {}", max_finger));
    const bool has_place = kind == Contact::Kind::down || kind == Contact::Kind::move;
    return {Contact{.kind = kind,
                    .finger = static_cast<int>(number),
                    .at = has_place ? arguments.place() : Vec2{},
                    .time = arguments.time}};
}

Input undo(Arguments& arguments) {
    return {KeyPress{.key = Key::undo, .time = arguments.time}};
}

/// A word of the script for a visitor's input.
struct InputWord {
    const char* word;
    const char* usage;
    Input (*read)(Arguments& arguments);
};

constexpr std::array<InputWord, 12> input_words{{
    {"tap", "a tap needs a place, 'X Y'", tap},
    {"hold", "a hold needs a place and a time, 'X Y SECONDS'", hold},
    {"drag", "a drag needs two places and a time, 'X Y X Y SECONDS'", drag},
    {"flick", "a flick needs two places, 'X Y X Y'", flick},
    {"pinch", "a pinch needs a place, a factor and a time, 'X Y FACTOR SECONDS'", pinch},
    {"wheel", "a wheel needs a place and a number of notches, 'X Y NOTCHES'", wheel},
    {"down", "a finger that comes down needs its number and a place, 'N X Y'", contact<Contact::Kind::down>},
    {"move", "a finger that moves needs its number and a place, 'N X Y'", contact<Contact::Kind::move>},
    {"up", "a finger that is lifted needs its number", contact<Contact::Kind::up>},
    {"cancel", "a finger that the panel takes back needs its number", contact<Contact::Kind::cancel>},
    {"key", "a key must be one of left, right, nearer, farther, select, back, undo", key},
    {"undo", "", undo},
}};

std::string all_words() {
    std::string words = "add, remove";
    for (const InputWord& word : input_words)
        words += fmt::format(", {}", word.word);
    return words + ", clock";
}

std::chrono::local_seconds clock_time(std::istringstream& words) {
    std::tm civil{};
    words >> std::get_time(&civil, "%Y-%m-%d %H:%M:%S");
    const std::chrono::year_month_day day{std::chrono::year(civil.tm_year + 1900),
                                          std::chrono::month(static_cast<unsigned>(civil.tm_mon + 1)),
                                          std::chrono::day(static_cast<unsigned>(civil.tm_mday))};
    if (words.fail() || !day.ok()) throw std::runtime_error("a clock needs 'YYYY-MM-DD HH:MM:SS'");
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
    if (!(words >> at >> what)) throw std::runtime_error("it must start with a time in seconds and an event");
    const std::chrono::nanoseconds time = seconds(at);
    if (what == "add" || what == "remove") return read_file(words, time, what == "add");
    if (what == "clock") return clocks_.push_back({.time = time, .shows = clock_time(words)});
    const auto known =
        std::ranges::find_if(input_words, [&](const InputWord& word) { return word.word == what; });
    if (known == input_words.end())
        throw std::runtime_error(fmt::format("an event must be one of {}", all_words()));
    next_finger_ += 2;  // gestures of several lines at the same time are those of several hands
    Arguments arguments{.words = words, .time = time, .usage = known->usage, .finger = next_finger_};
    const Input input = known->read(arguments);
    touches_.insert(touches_.end(), input.begin(), input.end());
}

void Rehearsal::read_file(std::istream& words, std::chrono::nanoseconds time, bool is_added) {
    words >> std::ws;
    const std::string path(std::istreambuf_iterator<char>(words), {});
    if (path.empty()) throw std::runtime_error("the name of the file is missing");
    files_.push_back({.time = time, .path = path, .is_added = is_added});
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
