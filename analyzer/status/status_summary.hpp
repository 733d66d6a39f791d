#pragma once

#include "analyzer/status/status_report.hpp"

#include <string>

namespace vitrine {

/// "27 files: 24 ready, 2 waiting, 1 unsupported"
std::string summary(const StatusReport& report);

}  // namespace vitrine
