#pragma once

#include "base/state/record.hpp"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vitrine {

// Which files bring the player down. It notes in STATE/playing what it has open, before it opens it; a note
// that is found at the next start was left by a crash. Who is to blame stands in STATE/blamed, which the
// analyzer reads: docs/catalogue.md.

constexpr const char* playing_file = "playing";  // below the state directory; written by the player alone
constexpr const char* blamed_file = "blamed";    // likewise

/// One content of one file.
struct ContentName {
    std::string id;  // record_id() of its path
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads the 0 inside the default
    friend auto operator<=>(const ContentName&, const ContentName&) = default;
};

ContentName content_name(const MediaRecord& record);

/// What one run of the player has open.
struct PlayingNote {
    std::string boot;  // of the kernel: what ended with the machine is nobody's fault
    int process = 0;
    std::set<ContentName> opening;  // since a few seconds
    std::set<ContentName> playing;  // longer

    friend bool operator==(const PlayingNote&, const PlayingNote&) = default;
};

/// Points of each content.
using Blame = std::map<ContentName, int>;

/// A content with so many points is quarantined: it was being opened in two crashes in a row, or played in
/// four, and was the only one of which that is true.
constexpr int most_blame = 4;

/// With fewer, but so many, it is a suspect.
constexpr int least_suspicion = 2;

/// The reason that its record gets.
constexpr const char* brought_the_player_down = "it brought the player down, again and again";

bool is_quarantined(const Blame& blame, const MediaRecord& record);

/// Those that were being opened are to blame, where there were any, else all that played. Who had no part in
/// the last crash is forgiven the one before, unless quarantined. Where several would be quarantined at once
/// it is not known whose fault it is: they stay suspects.
Blame blame_after(const Blame& before, const PlayingNote& crashed);

/// Those of the paths that anything is known of.
std::vector<std::string> suspects(const Blame& blame, const std::vector<std::string>& paths);

/// What the player has found out so far. @param state  the state directory
Blame read_blame(const std::filesystem::path& state);

/// Lines of words; what is not understood in them is passed over, for they only protect.
std::string to_text(const PlayingNote& note);
std::string to_text(const Blame& blame);
PlayingNote playing_note_from(const std::string& text);
Blame blame_from(const std::string& text);

}  // namespace vitrine
