#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace vitrine::analyzer {

/// The files that have a child, and those whose child died lately. Pure: times are passed in.
class AnalysisSlots {
  public:
    using Time = std::chrono::steady_clock::time_point;

    void begin(const std::string& path) { running_.insert(path); }

    void end(const std::string& path) { running_.erase(path); }

    bool contains(const std::string& path) const { return running_.contains(path); }

    std::size_t size() const { return running_.size(); }

    bool is_empty() const { return running_.empty(); }

    /// The file brought its child down.
    /// @param memory  as long, a death counts
    /// @return true where other files have done so within this time: one cause may have killed them all
    bool note_death(const std::string& path, Time now, std::chrono::milliseconds memory);

  private:
    std::set<std::string> running_;
    std::map<std::string, Time> died_;  // the last death of each file
};

}  // namespace vitrine::analyzer
