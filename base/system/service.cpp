#include "base/system/service.hpp"

#include "base/system/log.hpp"

#include <systemd/sd-daemon.h>

#include <cstdlib>
#include <cstring>
#include <utility>

namespace vitrine::service {

namespace {

void notify(const std::string& message) {
    const int result = sd_notify(0, message.c_str());
    if (result < 0) log::debug("systemd was not told '{}': {}", message, std::strerror(-result));
}

/// Makes one line of a status.
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

void feed_watchdog() {
    notify("WATCHDOG=1");
}

bool is_told() {
    return std::getenv("NOTIFY_SOCKET") != nullptr;
}

void hold(const std::string& name, int fd) {
    forget(name);
    const std::string message = "FDSTORE=1\nFDNAME=" + name;
    const int result = sd_pid_notify_with_fds(0, 0, message.c_str(), &fd, 1);
    if (result < 0) log::debug("systemd does not hold '{}': {}", name, std::strerror(-result));
}

void forget(const std::string& name) {
    notify("FDSTOREREMOVE=1\nFDNAME=" + name);
}

UniqueFd held(const std::string& name) {
    char** names = nullptr;
    const int count = sd_listen_fds_with_names(1, &names);
    UniqueFd found;
    for (int i = 0; i < count; ++i) {
        UniqueFd fd(SD_LISTEN_FDS_START + i);
        if (!found.is_open() && name == names[i]) found = std::move(fd);
        std::free(names[i]);
    }
    std::free(names);
    return found;
}

std::optional<std::chrono::microseconds> watchdog_interval() {
    std::uint64_t microseconds = 0;
    if (sd_watchdog_enabled(0, &microseconds) <= 0) return std::nullopt;
    return std::chrono::microseconds(microseconds);
}

}  // namespace vitrine::service
