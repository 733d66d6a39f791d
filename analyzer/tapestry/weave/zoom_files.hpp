#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"
#include "base/state/tapestry.hpp"

#include <filesystem>

namespace vitrine::analyzer {

/// Writes the zoom fields between a level and the one before it. The tiles of both must be there; the index
/// stays as it is.
/// @return  the share of the coarser strip that the finer one shows again, [0, 1]
/// @throws MediaError, std::system_error  naming a file that cannot be read or written
double write_zoom(const std::filesystem::path& directory, const Tapestry& tapestry, std::size_t finer,
                  const RunTasks& run);

}  // namespace vitrine::analyzer
