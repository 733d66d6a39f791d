#pragma once

#include "base/state/record.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

namespace vitrine {

constexpr const char* acquitted_file = "acquitted";  // below the state directory; only the player writes it

/// The files that a technician wants to be tried again, by the IDs of their records, with the times at which
/// that was said, in seconds since 1970. The ID "*" stands for all files.
using Acquittals = std::map<std::string, std::chrono::seconds>;

/// Reads STATE/acquitted. @param state  the state directory
Acquittals read_acquittals(const std::filesystem::path& state);

/// Adds an acquittal to STATE/acquitted. @param path  "": all files
/// @throws std::system_error
void write_acquittal(const std::filesystem::path& state, const std::string& path, std::chrono::seconds now);

/// True where the file was acquitted after its quarantine began.
bool is_acquitted(const Acquittals& acquittals, const std::string& path, const Fault& quarantine);

}  // namespace vitrine
