#pragma once

#include "analyzer/child/child_process.hpp"
#include "analyzer/watch/analysis_outcome.hpp"
#include "base/state/record.hpp"
#include "base/system/event_loop.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The command that analyses one file, and its limits.
struct AnalysisCommand {
    std::vector<std::string> words;   // a program that prints one record; arguments of the file are appended
    ChildLimits limits;               // for an empty file
    double seconds_per_mebibyte = 0;  // of processor time, see limits_for()
};

/// The analyses that run: one child process a file. Logs.
class Analyses {
  public:
    /// Both are called from the loop.
    struct Events {
        std::function<void(const MediaRecord& part)> grown;  // new shots of a film
        std::function<void(const FileFacts& facts, AnalysisOutcome outcome)> ended;
    };

    Analyses(EventLoop& loop, AnalysisCommand command, Events events);

    /// @param arguments  appended to the command
    /// @throws std::system_error where no process can be made
    void start(const std::string& path, const FileFacts& facts, const std::vector<std::string>& arguments);

    /// Kills the child of a file that has one; its end is still reported.
    void stop(const std::string& path) { running_.at(path).process->stop(); }

    bool is_idle() const { return running_.empty(); }

    /// "looking at 'a.mp4' for 12 s, 'b.mp4' for 3 min"; empty where none runs.
    std::string in_words() const;

  private:
    struct Running {
        EventLoop::Clock::time_point since;
        std::unique_ptr<ChildProcess> process;
    };

    void read_line(const std::string& path, const FileFacts& facts, const std::string& line);

    EventLoop& loop_;  // outlives this
    AnalysisCommand command_;
    Events events_;
    std::map<std::string, Running> running_;  // by path
};

}  // namespace vitrine::analyzer
