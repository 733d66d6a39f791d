#pragma once

#include "analyzer/tapestry/synthesis/keyframes.hpp"
#include "analyzer/tapestry/weave/candidate_file.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The plan of a weaving: kept beside the tapestry until that is complete, so that a weaving that was cut off
/// goes on.
struct WeavePlan {
    std::string folder;             // of the tiles, below the index
    std::vector<Keyframes> levels;  // coarsest first, as numbers of the film's candidates

    bool operator==(const WeavePlan&) const = default;
};

/// The plan in a tapestry's folder; nothing where there is none for that film, or it makes no sense.
/// @param candidates  how many the film has
std::optional<WeavePlan> read_plan(const std::filesystem::path& directory, const FilmContent& content,
                                   std::size_t candidates);

/// @throws std::system_error
void write_plan(const std::filesystem::path& directory, const FilmContent& content, const WeavePlan& plan);

void remove_plan(const std::filesystem::path& directory);

}  // namespace vitrine::analyzer
