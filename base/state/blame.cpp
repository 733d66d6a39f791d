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

bool is_quarantined(const Suspicion& suspicion, std::chrono::seconds now) {
    return suspicion.points >= quarantine_points &&
           now < suspicion.since + quarantine_time(suspicion.quarantines);
}

/// The suspicion as it is now: after a quarantine one more crash brings the next.
Suspicion current(Suspicion suspicion, std::chrono::seconds now) {
    if (!is_quarantined(suspicion, now)) suspicion.points = std::min(suspicion.points, quarantine_points - 1);
    return suspicion;
}

}  // namespace

ContentName content_name(const MediaRecord& record) {
    return {.id = record_id(record.path), .bytes = record.bytes, .mtime_ns = record.mtime_ns};
}

std::chrono::seconds quarantine_time(int quarantines) {
    using std::chrono::days;
    return quarantines <= 1 ? days(1) : days(7);
}

std::optional<Suspicion> find_quarantine(const Blame& blame, const MediaRecord& record,
                                         std::chrono::seconds now) {
    if (blame.empty()) return std::nullopt;
    const auto found = blame.find(content_name(record));
    if (found == blame.end() || !is_quarantined(found->second, now)) return std::nullopt;
    return found->second;
}

std::size_t count_quarantined(const Blame& blame, std::chrono::seconds now) {
    return static_cast<std::size_t>(
        std::ranges::count_if(blame, [&](const auto& entry) { return is_quarantined(entry.second, now); }));
}

Blame blame_after(const Blame& before, const PlayingNote& crashed, std::chrono::seconds now) {
    Blame after;
    for (const auto& [name, suspicion] : before)
        if (suspicion.quarantines > 0) after[name] = current(suspicion, now);
    const bool was_opening = !crashed.opening.empty();
    std::vector<Suspicion*> quarantined;
    for (const ContentName& name : was_opening ? crashed.opening : crashed.playing) {
        const auto known = before.find(name);
        Suspicion& suspicion = after[name] =
            known == before.end() ? Suspicion{} : current(known->second, now);
        if (suspicion.points >= quarantine_points) continue;
        suspicion.points =
            std::min(suspicion.points + (was_opening ? opening_points : playing_points), quarantine_points);
        if (suspicion.points == quarantine_points) quarantined.push_back(&suspicion);
    }
    for (Suspicion* suspicion : quarantined) {
        if (quarantined.size() > 1) {
            suspicion->points = quarantine_points - 1;
        } else {
            suspicion->since = now;
            ++suspicion->quarantines;
        }
    }
    return after;
}

Blame blame_after_reader(Blame blame, const ContentName& name, bool is_alone, std::chrono::seconds now) {
    Suspicion& suspicion = blame[name];
    suspicion = current(suspicion, now);
    if (suspicion.points >= quarantine_points) return blame;
    suspicion.points = std::min(suspicion.points + opening_points, quarantine_points);
    if (suspicion.points < quarantine_points) return blame;
    if (!is_alone) {
        suspicion.points = quarantine_points - 1;
    } else {
        suspicion.since = now;
        ++suspicion.quarantines;
    }
    return blame;
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
    for (const auto& [name, suspicion] : blame)
        text += fmt::format("{} {} {} {} {} {}\n", suspicion.points, name.id, name.bytes, name.mtime_ns,
                            suspicion.since.count(), suspicion.quarantines);
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
        if (!name || first.size() != 1 || first < "1" || first > "9") return;
        std::int64_t since = 0;
        int quarantines = 0;
        if (!(words >> since >> quarantines)) since = quarantines = 0;  // of an earlier version
        blame[*name] = {.points = std::min(first[0] - '0', quarantine_points),
                        .since = std::chrono::seconds(since),
                        .quarantines = quarantines};
    });
    return blame;
}

}  // namespace vitrine
