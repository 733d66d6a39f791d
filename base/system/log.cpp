#include "base/system/log.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <utility>

namespace vitrine::log {

namespace {

struct LevelName {
    Level level;
    std::string_view name;
    int priority;  // syslog's: 3 error, 4 warning, 6 info, 7 debug
};

constexpr std::array<LevelName, 4> levels{{{Level::error, "error", 3},
                                           {Level::warning, "warning", 4},
                                           {Level::info, "info", 6},
                                           {Level::debug, "debug", 7}}};

std::atomic<Level> highest = Level::info;  // the only global of the tree

}  // namespace

void set_level(Level level) {
    highest = level;
}

bool is_wanted(Level level) {
    return level <= highest;
}

std::string line_of(Level level, std::string_view message, bool for_journal) {
    const LevelName& entry = levels.at(static_cast<std::size_t>(level));
    std::string line;
    if (for_journal)
        line = fmt::format("<{}>", entry.priority);
    else if (level != Level::info)
        line = fmt::format("{}: ", entry.name);
    for (const char c : message) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f)
            line += fmt::format("\\x{:02x}", byte);
        else
            line += c;
    }
    return line + "\n";
}

bool is_journal(int fd) {
    const char* stream = std::getenv("JOURNAL_STREAM");

    struct stat info {};

    if (stream == nullptr || ::fstat(fd, &info) < 0) return false;
    return fmt::format("{}:{}", info.st_dev, info.st_ino) == stream;
}

void write(Level level, std::string_view message) {
    if (!is_wanted(level)) return;
    static const bool for_journal = is_journal(STDERR_FILENO);
    const std::string line = line_of(level, message, for_journal);
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;  // there is no other place to report it
}

}  // namespace vitrine::log
