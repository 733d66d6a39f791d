#pragma once

#include "base/hints/hints.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace vitrine {

constexpr int max_dwell_seconds = 86400;
constexpr int max_repeats = 20;

/// The name that is read: of a folder, or of a file with its extension.
enum class NamePart { folder, file };

/// The words of a name that have not been read yet. Words are divided by spaces or '_'.
struct NameWords {
    std::string_view rest;
    NamePart part = NamePart::folder;

    /// Removes the next word and returns it; empty at the end.
    std::string_view next();
};

/// A value in `.vitrine.toml` or hints.json.
using HintValue = std::variant<bool, std::int64_t, std::string>;

/// One hint. A new hint needs its member of Hints, its entry in the table of hint_words.cpp, its user, and
/// its line in the operator's document.
struct HintWord {
    std::string_view key;      // in `.vitrine.toml` and hints.json
    std::string_view allowed;  // the allowed values, in words

    bool (*assign)(Hints&, const HintValue&);         // false: the value is not allowed
    std::optional<HintValue> (*value)(const Hints&);  // none: the hint is not set
    /// false: the word is another hint or a name, or the hint was set before
    bool (*read)(Hints&, std::string_view word, NameWords&);
    std::string (*in_words)(const Hints&);            // for the operator; call it only if the hint is set
    void (*merge)(Hints& outer, const Hints& inner);  // takes the inner hint if it is set
};

/// All hints, in the order in which files and sentences list them.
std::span<const HintWord> hint_words();

/// The hints that a name begins with. They end at the first word that is no hint or a repeated one. The
/// extension of a file does not count. "12-14 team.jpg" has no hint: in the names of files hours need their
/// minutes.
/// @param name  one folder or file without its path, any bytes
Hints hints_in_name(std::string_view name, NamePart part);

/// A name for visitors: without the hints that it begins with, a number for ordering, and a file's extension;
/// '_' becomes a space. "2026-12-01 01_Summer" is "Summer". May be empty.
std::string plain_name(std::string_view name, NamePart part);

/// The name of a folder as visitors read it: the plain name of the last part of its path, or that part as it
/// is where nothing of it is plain.
/// @param path  below the media folder, any bytes
std::string shown_folder_name(std::string_view path);

/// All that can be the caption of a file.
struct CaptionSources {
    std::string_view written;                      // by the operator; empty: nothing
    std::string_view own;                          // what the file itself says; empty: nothing
    std::string_view path;                         // below the media folder; empty: names are no captions
    std::optional<std::chrono::local_days> day{};  // told by its year; none: the day does not matter
};

/// The caption of a file: what was written, else what the file says, else its name without hints, numbers and
/// ending. The year stands before it: "2019 · At the lake", or alone. May be empty.
std::string caption_of(const CaptionSources& sources);

/// The hints of something inside something else: an inner hint replaces the outer one.
Hints merged(const Hints& outer, const Hints& inner);

/// A sentence part for the operator: "from 2026-12-01 to 2026-12-24, from 08:00 to 18:00, for 20 seconds, 3
/// times as often". Empty for no hints.
std::string in_words(const Hints& hints);

}  // namespace vitrine
