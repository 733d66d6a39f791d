#pragma once

#include "analyzer/status/file_state.hpp"
#include "analyzer/watch/schedule.hpp"
#include "base/state/record.hpp"

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Tells where each file stands: the schedule knows how far it has come, the records what was found.
class FileStates {
  public:
    /// The catalogue has this record now, in place of an earlier one of that path.
    void note_record(const MediaRecord& record);

    void forget_file(const std::string& path);

    /// A child looks at the file: it is outdated no more, whatever comes of it.
    void note_analysis(const std::string& path) { outdated_.erase(path); }

    /// The files whose records an earlier version of the analysis wrote.
    const std::set<std::string>& outdated_files() const { return outdated_; }

    /// What must be known of a file so that its captions can be set.
    struct OwnCaption {
        std::string text;                              // that the file says itself; empty: nothing
        std::optional<std::chrono::local_days> day{};  // on which a camera took it
    };

    OwnCaption caption(const std::string& path) const;

    StateCounts counts(const Schedule& schedule) const;

    /// The quarantined files that are to be tried again.
    /// @param is_over  says so of each
    std::vector<std::string> quarantined_files(
        const std::function<bool(const std::string& path, const Fault& quarantine)>& is_over) const;

    /// All files, ordered by path.
    /// @param clock, now  the same moment by two clocks: the schedule's is not one that people read
    std::vector<FileState> list(const Schedule& schedule, Schedule::Time clock,
                                std::chrono::system_clock::time_point now) const;

  private:
    struct Found {
        MediaState state = MediaState::waiting;
        std::string reason;
        Fault fault;
        OwnCaption caption{};
    };

    const Found* found(const std::string& path, Schedule::Progress progress) const;
    static FileState::State state_of(const Found* found, Schedule::Progress progress);

    std::map<std::string, Found> found_;
    std::set<std::string> outdated_;
};

}  // namespace vitrine::analyzer
