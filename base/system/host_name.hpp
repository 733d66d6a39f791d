#pragma once

#include <string>

namespace vitrine {

/// The machine's name. Empty: it has none.
std::string host_name();

}  // namespace vitrine
