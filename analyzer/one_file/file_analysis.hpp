#pragma once

#include "base/settings/settings.hpp"
#include "base/state/record.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::analyzer {

/// What an analysis leaves in the state directory, and what it takes.
struct Keeping {
    bool stores = false;         // a copy or clips in the store (settings.store), for the player to play from
    bool has_sound = false;      // of a film, in the store too
    bool has_thumbnail = false;  // for the status folder
    bool takes_cut_streams = false;  // one that breaks off inside a packet was waited for long enough
    bool has_frames = false;  // for the film's tapestry (settings.tapestry), where that is still to be woven
};

/// The record of one file as it is now: with its shots, or with the reason why there are none. A film that
/// turns out to be damaged behind its first shots keeps them, and has the reason too.
///
/// @param file  anywhere; its path in the record is relative to settings.media.root where it lies in there
/// @param keeping  what else becomes of it
/// @param grown  sees what is new of a film whenever a shot is over, a record of the new shots alone, and
/// again of a shot alone when its place in the store becomes known
/// @throws std::system_error where there is no such file
MediaRecord record_of_file(const std::filesystem::path& file, const Settings& settings,
                           const Keeping& keeping = {},
                           const std::function<void(const MediaRecord&)>& grown = {});

/// Leaves the thumbnail of a file whose record is in the catalogue.
/// @return whether there is one now
/// @throws MediaError where the file cannot be read
bool leave_thumbnail(const std::filesystem::path& file, const Settings& settings);

/// The longest side of the clips that are made for the store, px: as set, or as the screens need them.
int clip_side(const Settings& settings);

/// Writes the sheet that shows how the file's regions came about, as PNG.
/// @return the record
/// @throws MediaError where there is nothing to show
MediaRecord explain_file(const std::filesystem::path& file, const std::string& sheet,
                         const Settings& settings);

}  // namespace vitrine::analyzer
