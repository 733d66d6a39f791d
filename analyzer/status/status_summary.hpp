#pragma once

#include "analyzer/status/file_state.hpp"

#include <string>

namespace vitrine::analyzer {

/// "27 files: 24 ready, 2 waiting, 1 unsupported"
std::string summary(const StateCounts& counts);

}  // namespace vitrine::analyzer
