#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace vitrine {

// The player tells the analyzer which film's tapestry a visitor waits for: docs/catalogue.md, "A tapestry".

/// Below the state directory; only the player writes it.
constexpr const char* wanted_tapestry_file = "wanted_tapestry.json";

/// An older wish was left by a player that no longer runs, or by a visitor who has gone.
constexpr std::chrono::minutes max_wish_age{10};

/// The path of the film's record; "" if nobody waits, or the file is old or cannot be read.
/// @param state  the state directory
std::string wanted_tapestry(const std::filesystem::path& state, std::filesystem::file_time_type now);

/// Replaces the wish. @param path  as in the film's record, any bytes
/// @throws std::system_error
void want_tapestry(const std::filesystem::path& state, const std::string& path);

/// Withdraws the wish if it still names this film.
void withdraw_wish(const std::filesystem::path& state, const std::string& path);

}  // namespace vitrine
