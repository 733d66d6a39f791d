#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The progress of the tapestry of one content of a film.
enum class TapestryState {
    lacking,   // it must be woven, or weaving must go on
    complete,  // all of its levels are there
    dropped,   // it lost its place to others: it is not woven again
};

/// A film's content, and the keyframes that a person has chosen for it.
struct FilmVersion {
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;
    std::string choice{};  // see key_of(); "": none

    bool operator==(const FilmVersion&) const = default;
};

/// @param folder  the film's, see tapestry_folder()
TapestryState tapestry_state(const std::filesystem::path& folder, const FilmVersion& film);

/// The same for any choice of keyframes.
TapestryState tapestry_state(const std::filesystem::path& folder, std::uint64_t bytes, std::int64_t mtime_ns);

/// Notes that the tapestry of that content is not woven again. @throws std::system_error
void note_dropped(const std::filesystem::path& folder, std::uint64_t bytes, std::int64_t mtime_ns);

/// Removes that note: the tapestry is woven again.
void forget_drop(const std::filesystem::path& folder);

/// The bytes that one tapestry may take, and those of its film's frames.
/// @param max_bytes  for all tapestries
constexpr std::uint64_t tapestry_share(std::uint64_t max_bytes) {
    constexpr int min_tapestries = 4;
    return max_bytes / min_tapestries;
}

}  // namespace vitrine::analyzer
