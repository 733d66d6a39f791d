#include "base/system/service.hpp"

#include "base/system/log.hpp"

#include <systemd/sd-daemon.h>

#include <cstring>

namespace vitrine::service {

namespace {

void notify(const std::string& message) {
    const int result = sd_notify(0, message.c_str());
    if (result < 0) log::debug("systemd was not told '{}': {}", message, std::strerror(-result));
}

/// A status is one line.
std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

}  // namespace

void ready(const std::string& status) {
    notify("READY=1\nSTATUS=" + one_line(status));
}

void status(const std::string& text) {
    notify("STATUS=" + one_line(text));
}

void stopping() {
    notify("STOPPING=1");
}

void alive() {
    notify("WATCHDOG=1");
}

std::optional<std::chrono::microseconds> watchdog_interval() {
    std::uint64_t microseconds = 0;
    if (sd_watchdog_enabled(0, &microseconds) <= 0) return std::nullopt;
    return std::chrono::microseconds(microseconds);
}

}  // namespace vitrine::service
