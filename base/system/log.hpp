#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

/// Writes log lines for the journal or a terminal. Thread-safe: each line is one write to the standard error.
/// Only the daemon, the player, the two main() and the reader of the settings file log above debug; one event
/// gives one line.
namespace vitrine::log {

enum class Level { error, warning, info, debug };

/// Drops lines that are less important than this. It starts at info.
void set_level(Level level);

bool is_wanted(Level level);

/// Writes one line. Control characters are written as \xNN, so that a file name cannot forge a line.
void write(Level level, std::string_view message);

/// True if systemd reads this file descriptor into the journal. systemd names its stream by device and inode,
/// so that a redirected descriptor is not mistaken for it.
bool is_journal(int fd);

/// The line as it is written. @param for_journal  begins it with the priority that the journal reads, "<6>"
std::string line_of(Level level, std::string_view message, bool for_journal);

template <typename... Args> void error(fmt::format_string<Args...> text, Args&&... args) {
    write(Level::error, fmt::format(text, std::forward<Args>(args)...));
}

template <typename... Args> void warning(fmt::format_string<Args...> text, Args&&... args) {
    if (is_wanted(Level::warning)) write(Level::warning, fmt::format(text, std::forward<Args>(args)...));
}

template <typename... Args> void info(fmt::format_string<Args...> text, Args&&... args) {
    if (is_wanted(Level::info)) write(Level::info, fmt::format(text, std::forward<Args>(args)...));
}

template <typename... Args> void debug(fmt::format_string<Args...> text, Args&&... args) {
    if (is_wanted(Level::debug)) write(Level::debug, fmt::format(text, std::forward<Args>(args)...));
}

}  // namespace vitrine::log
