#include "base/system/journal.hpp"

#define SD_JOURNAL_SUPPRESS_LOCATION
#include <sys/uio.h>
#include <systemd/sd-journal.h>
#include <unistd.h>

#include <cerrno>

namespace vitrine::log {

std::vector<std::string> journal_entry(Level level, std::string_view message,
                                       const std::vector<Field>& fields) {
    const std::string line = line_of(level, message, true);  // "<6>...\n", safe to print
    std::vector<std::string> entry{"MESSAGE=" + line.substr(3, line.size() - 4),
                                   std::string("PRIORITY=") + line[1],
                                   std::string("SYSLOG_IDENTIFIER=") + ::program_invocation_short_name};
    for (const Field& field : fields)
        entry.push_back(std::string(field.name) + "=" + field.value);
    return entry;
}

void write_with(Level level, std::string_view message, const std::vector<Field>& fields) {
    if (!is_wanted(level)) return;
    static const bool for_journal = is_journal(STDERR_FILENO);
    if (!for_journal) return write(level, message);
    const std::vector<std::string> entry = journal_entry(level, message, fields);
    std::vector<iovec> parts;
    parts.reserve(entry.size());
    for (const std::string& part : entry)
        parts.push_back({.iov_base = const_cast<char*>(part.data()), .iov_len = part.size()});
    if (sd_journal_sendv(parts.data(), static_cast<int>(parts.size())) < 0) write(level, message);
}

}  // namespace vitrine::log
