#pragma once

#include <string>

namespace vitrine {

struct Settings;

/// The address at which files are dropped, with this machine's name in place of "{host}". Empty: none is
/// told.
std::string share_address(const Settings& settings);

}  // namespace vitrine
