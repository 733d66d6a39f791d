#pragma once

#include "base/state/record.hpp"

#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine {

// Finds the files that crash the player. The player notes each file in STATE/playing before it opens it. A
// note that exists at the next start was left by a crash. The player then writes the files at fault into
// STATE/blamed, which the analyzer reads: docs/catalogue.md.

constexpr const char* playing_file = "playing";  // below the state directory; only the player writes it
constexpr const char* blamed_file = "blamed";    // below the state directory; only the player writes it

/// A reader has news of its file.
enum class FileNews { opens, crashed_its_reader };

/// One content of one file.
struct ContentName {
    std::string id;  // record_id() of its path
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads the 0 inside the default
    auto operator<=>(const ContentName&) const = default;
};

ContentName content_name(const MediaRecord& record);

/// The files that one run of the player has open.
struct PlayingNote {
    std::string boot;  // ID of the kernel's boot: if the machine crashed as well, no file is at fault
    int process = 0;
    std::set<ContentName> opening;  // opened a few seconds ago
    std::set<ContentName> playing;  // opened earlier

    bool operator==(const PlayingNote&) const = default;
};

/// The part that one content had in crashes.
struct Suspicion {
    int points = 0;
    std::chrono::seconds since{0};  // the begin of its last quarantine, by the wall clock
    int quarantines = 0;

    bool operator==(const Suspicion&) const = default;
};

using Blame = std::map<ContentName, Suspicion>;

/// The duration of a quarantine.
/// @param quarantines  quarantines of this content so far, with this one
std::chrono::seconds quarantine_time(int quarantines);

/// A content with so many points is quarantined if it is the only one: it was being opened in two crashes in
/// a row, or played in four.
constexpr int quarantine_points = 4;

/// A content with so many points is a suspect.
constexpr int suspect_points = 2;

/// The reason in the record of a quarantined content.
constexpr const char* brought_the_player_down = "it crashed the player or its reader, again and again";

/// The quarantine that a content is in; nothing where it is in none. A quarantine ends by itself.
/// @param now  the wall clock
std::optional<Suspicion> find_quarantine(const Blame& blame, const MediaRecord& record,
                                         std::chrono::seconds now);

/// The number of contents that are quarantined. @param now  the wall clock
std::size_t count_quarantined(const Blame& blame, std::chrono::seconds now);

/// Gives points after a crash to the contents that were being opened, or, if there were none, to all that
/// played. A content that had no part in the last crash loses its points, unless it is quarantined. If
/// several would be quarantined at once, it is not known which is at fault, and they stay suspects. A content
/// whose quarantine is over is as suspect as one can be.
/// @param now  the wall clock
Blame blame_after(const Blame& before, const PlayingNote& crashed, std::chrono::seconds now);

/// Gives points to a content that made its own reader crash: which one it was is known then. Two such crashes
/// quarantine it.
/// @param is_alone  false: other contents made theirs crash, too, so the fault may be elsewhere; it stays a
/// suspect
/// @param now  the wall clock
Blame blame_after_reader(Blame blame, const ContentName& name, bool is_alone, std::chrono::seconds now);

/// The paths with points.
std::vector<std::string> suspects(const Blame& blame, const std::vector<std::string>& paths);

/// Reads STATE/blamed. @param state  the state directory
Blame read_blame(const std::filesystem::path& state);

// The text form: lines of words. Unknown words are ignored, because the notes only protect.
std::string to_text(const PlayingNote& note);
std::string to_text(const Blame& blame);
PlayingNote playing_note_from(const std::string& text);
Blame blame_from(const std::string& text);

}  // namespace vitrine
