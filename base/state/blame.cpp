#include "base/state/blame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

namespace vitrine {

namespace {

constexpr int opening_points = 2;
constexpr int playing_points = 1;
constexpr std::size_t max_lines = 10'000;

std::string in_words(const ContentName& name) {
    return fmt::format("{} {} {}\n", name.id, name.bytes, name.mtime_ns);
}

std::optional<ContentName> name_in(std::istream& words) {
    ContentName name;
    if (!(words >> name.id >> name.bytes >> name.mtime_ns)) return std::nullopt;
    return name;
}

template <typename Use> void for_each_line(const std::string& text, const Use& use) {
    std::istringstream lines(text);
    std::string line;
    for (std::size_t i = 0; i < max_lines && std::getline(lines, line); ++i) {
        std::istringstream words(line);
        std::string first;
        if (words >> first) use(first, words);
    }
}

}  // namespace

ContentName content_name(const MediaRecord& record) {
    return {.id = record_id(record.path), .bytes = record.bytes, .mtime_ns = record.mtime_ns};
}

bool is_quarantined(const Blame& blame, const MediaRecord& record) {
    if (blame.empty()) return false;
    const auto found = blame.find(content_name(record));
    return found != blame.end() && found->second >= quarantine_points;
}

Blame blame_after(const Blame& before, const PlayingNote& crashed) {
    Blame after;
    for (const auto& [name, points] : before)
        if (points >= quarantine_points) after[name] = points;
    const bool was_opening = !crashed.opening.empty();
    for (const ContentName& name : was_opening ? crashed.opening : crashed.playing) {
        const auto known = before.find(name);
        const int points =
            (known == before.end() ? 0 : known->second) + (was_opening ? opening_points : playing_points);
        after[name] = std::min(points, quarantine_points);
    }
    const auto is_new = [&](const auto& entry) {
        const auto known = before.find(entry.first);
        return entry.second == quarantine_points &&
               (known == before.end() || known->second < quarantine_points);
    };
    if (std::ranges::count_if(after, is_new) > 1)
        for (auto& entry : after)
            if (is_new(entry)) entry.second = quarantine_points - 1;
    return after;
}

std::vector<std::string> suspects(const Blame& blame, const std::vector<std::string>& paths) {
    std::vector<std::string> found;
    if (blame.empty()) return found;
    std::set<std::string> ids;
    for (const auto& [name, points] : blame)
        ids.insert(name.id);
    std::ranges::copy_if(paths, std::back_inserter(found),
                         [&](const std::string& path) { return ids.contains(record_id(path)); });
    return found;
}

Blame read_blame(const std::filesystem::path& state) {
    std::ifstream stream(state / blamed_file, std::ios::binary);
    return blame_from({std::istreambuf_iterator<char>(stream), {}});
}

std::string to_text(const PlayingNote& note) {
    std::string text = fmt::format("run {} {}\n", note.boot, note.process);
    for (const ContentName& name : note.opening)
        text += "opening " + in_words(name);
    for (const ContentName& name : note.playing)
        text += "playing " + in_words(name);
    return text;
}

std::string to_text(const Blame& blame) {
    std::string text;
    for (const auto& [name, points] : blame)
        text += fmt::format("{} {}", points, in_words(name));
    return text;
}

PlayingNote playing_note_from(const std::string& text) {
    PlayingNote note;
    for_each_line(text, [&](const std::string& first, std::istream& words) {
        if (first == "run") {
            words >> note.boot >> note.process;
        } else if (first == "opening" || first == "playing") {
            if (const auto name = name_in(words))
                (first == "opening" ? note.opening : note.playing).insert(*name);
        }
    });
    return note;
}

Blame blame_from(const std::string& text) {
    Blame blame;
    for_each_line(text, [&](const std::string& first, std::istream& words) {
        const auto name = name_in(words);
        if (name && first.size() == 1 && first >= "1" && first <= "9")
            blame[*name] = std::min(first[0] - '0', quarantine_points);
    });
    return blame;
}

}  // namespace vitrine
