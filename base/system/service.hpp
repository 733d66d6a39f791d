#pragma once

#include "base/system/unique_fd.hpp"

#include <chrono>
#include <optional>
#include <string>

/// Messages to systemd (sd_notify). They do nothing if systemd did not start the program.
namespace vitrine::service {

void ready(const std::string& status);
void status(const std::string& text);
void stopping();

/// True if messages reach systemd, or a program that replaces it.
bool is_told();

/// Lets systemd hold a descriptor for the next process of the service. It replaces a descriptor that systemd
/// held under that name. systemd closes it when the service is stopped for good. FileDescriptorStoreMax= must
/// allow it.
void hold(const std::string& name, int fd);

/// Lets systemd close a descriptor that it holds.
void forget(const std::string& name);

/// Takes the descriptor that the last process of the service left with systemd under this name, and closes
/// all others that it left. Call it once, before any thread starts.
UniqueFd held(const std::string& name);

/// Feeds the watchdog of systemd. Call it more often than watchdog_interval(), and only while the service
/// does its work.
void feed_watchdog();

/// The time that systemd waits for feed_watchdog() before it restarts the service. None: it does not wait.
std::optional<std::chrono::microseconds> watchdog_interval();

}  // namespace vitrine::service
