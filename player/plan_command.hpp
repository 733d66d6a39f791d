#pragma once

#include "base/settings/settings.hpp"

#include <filesystem>
#include <optional>

namespace vitrine::player {

/// The options of `vitrine-player plan`.
struct PlanOptions {
    std::filesystem::path catalogue;  // the directory of records
    int width = 0;                    // canvas px
    int height = 0;
    int wall_width = 0;  // px of a wall that pans; 0: none is planned
    std::optional<std::filesystem::path> svg;
    std::optional<std::filesystem::path> json;  // neither json nor film: JSON to the standard output
    std::optional<std::filesystem::path> film;  // a film of the packing's steps
};

/// Lays out, without a display, the first wall that the player would show of a catalogue. An empty catalogue
/// gives an empty plan. @throws std::runtime_error naming the file that cannot be read or written
void write_plan(const Settings& settings, const PlanOptions& options);

}  // namespace vitrine::player
