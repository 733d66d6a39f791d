#pragma once

#include "analyzer/tapestry/synthesis/keyframes.hpp"
#include "analyzer/tapestry/weave/candidate_file.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The plan of a weaving. It is kept beside the tapestry until that is complete, so that an interrupted
/// weaving can go on.
struct WeavePlan {
    std::string folder;             // folder of the tiles, relative to the index
    std::vector<Keyframes> levels;  // coarsest first, as numbers of the film's candidates

    bool operator==(const WeavePlan&) const = default;
};

/// The film and the choice of its keyframes that a plan is for.
struct PlanSubject {
    FilmContent content;
    std::string choice{};  // its key; "": none
};

/// The plan in a tapestry's folder; nothing where there is none for that subject, or it is not valid.
/// @param candidates  number of candidates of the film
std::optional<WeavePlan> read_plan(const std::filesystem::path& directory, const PlanSubject& subject,
                                   std::size_t candidates);

/// @throws std::system_error
void write_plan(const std::filesystem::path& directory, const PlanSubject& subject, const WeavePlan& plan);

void remove_plan(const std::filesystem::path& directory);

}  // namespace vitrine::analyzer
