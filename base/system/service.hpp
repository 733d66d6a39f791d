#pragma once

#include <chrono>
#include <optional>
#include <string>

/// What is told to systemd (sd_notify); nothing happens where systemd did not start the program.
namespace vitrine::service {

void ready(const std::string& status);
void status(const std::string& text);
void stopping();

/// To be called more often than watchdog_interval(), and only while what the service is for is being done.
void alive();

/// How long systemd waits for alive() before it restarts the service; nothing where it does not.
std::optional<std::chrono::microseconds> watchdog_interval();

}  // namespace vitrine::service
