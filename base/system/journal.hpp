#pragma once

#include "base/system/log.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::log {

/// A value of a log line by which the journal can be searched:
/// `journalctl VITRINE_FILE=trips/a.jpg`, `journalctl VITRINE_STATE=quarantined`.
struct Field {
    std::string_view name;  // capitals and underscores, beginning with VITRINE_, or MESSAGE_ID
    std::string value;      // any bytes
};

/// MESSAGE_ID of the line that names a file at fault. It finds the line even if its text changes.
constexpr const char* file_at_fault = "9d0f6a5c1e7b4c2f8a3be5d27c41f06b";

/// Writes one line. Adds the fields if the standard error is the journal; else writes it like write().
void write_with(Level level, std::string_view message, const std::vector<Field>& fields);

/// The assignments for the journal: "MESSAGE=..." and so on.
std::vector<std::string> journal_entry(Level level, std::string_view message,
                                       const std::vector<Field>& fields);

}  // namespace vitrine::log
