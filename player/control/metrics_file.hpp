#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace vitrine::player {

/// Writes a text for a node exporter every 15 seconds, replacing the file by rename. Not fsynced: after a
/// power cut it is written again anyway. Logs.
class MetricsFile {
  public:
    /// @param file  empty: nothing is written
    /// @param text  called if the file is due
    void write_if_due(const std::string& file, std::chrono::nanoseconds now,
                      const std::function<std::string()>& text);

  private:
    std::chrono::nanoseconds next_{0};
    std::string complaint_;  // the complaint logged last
};

/// Degrees Celsius of the hottest thermal zone. None: the machine has no zone.
std::optional<double> temperature();

}  // namespace vitrine::player
