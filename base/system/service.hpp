#pragma once

#include "base/system/unique_fd.hpp"

#include <chrono>
#include <optional>
#include <string>

/// What is told to systemd (sd_notify); nothing happens where systemd did not start the program.
namespace vitrine::service {

void ready(const std::string& status);
void status(const std::string& text);
void stopping();

/// Whether systemd, or who stands in for it, is told anything at all.
bool is_told();

/// Has systemd hold a descriptor for the next process of the service, in place of what it held under that
/// name. It is closed when the service is stopped for good. FileDescriptorStoreMax= allows it.
void hold(const std::string& name, int fd);

/// It is not held any more.
void forget(const std::string& name);

/// What the last process of the service had held under this name. All others that were handed over are
/// closed. To be called once, before any thread starts.
UniqueFd held(const std::string& name);

/// To be called more often than watchdog_interval(), and only while what the service is for is being done.
void alive();

/// How long systemd waits for alive() before it restarts the service; nothing where it does not.
std::optional<std::chrono::microseconds> watchdog_interval();

}  // namespace vitrine::service
