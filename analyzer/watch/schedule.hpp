#pragma once

#include "analyzer/watch/analysis_slots.hpp"
#include "analyzer/watch/attempts.hpp"
#include "analyzer/watch/file_facts.hpp"
#include "analyzer/watch/leaving_files.hpp"
#include "analyzer/watch/pace.hpp"

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// One thing to do to the catalogue or the children.
struct Action {
    enum class Kind {
        start,   // a child for `path`; finish_analysis() must follow
        stop,    // the child of `path`: its file changed or went; finish_analysis() must follow
        hold,    // the record of `path` becomes waiting: the file keeps changing
        move,    // the record of `from` becomes that of `path`
        remove,  // the record of `path` goes
    };

    Kind kind = Kind::start;
    std::string path;
    std::string from;          // move only
    FileFacts facts;           // start and hold: facts of the file as it was seen
    bool is_last_try = false;  // start only: no retry follows a waiting answer

    bool operator==(const Action&) const = default;
};

/// Decides which file is analysed when. Pure: sees no file and no clock, so that every order of events can be
/// tested.
///
/// seen -> settling (until unchanged for the quiet time) -> due -> running -> done; a change leads back to
/// settling from anywhere, a waiting answer too, with growing delays. A file becomes due only when another
/// look after its quiet time finds it unchanged: files_to_look_at() names it, see_file() or lose_file() is
/// the answer. Times are the caller's monotonic clock.
class Schedule {
  public:
    using Time = std::chrono::steady_clock::time_point;

    explicit Schedule(const Pace& pace);

    /// Adds the record that an earlier run left.
    /// @param is_settled  it holds while the file is unchanged; else the file is analysed anew
    /// @param is_held     it is `waiting`
    void add_recorded(const std::string& path, const FileFacts& facts, bool is_settled, bool is_held);

    /// The file is there. Quiet is measured by these calls only: the times that a file carries come from
    /// clocks that are set, or from other machines.
    void see_file(const std::string& path, const FileFacts& facts, Time now, LookKind look = LookKind::local);

    /// The file is not there. For a rename, call this before see_file() of the new name.
    void lose_file(const std::string& path, Time now);

    /// The catalogue is about to have a record of a file that is still being analysed.
    /// @return false where the file changed or went in the meantime: it must not have one
    bool mark_grown(const std::string& path);

    Verdict finish_analysis(const std::string& path, Answer answer, Time now);

    /// Analyses a file once more though its record stands, because more is to be known of it.
    /// @return false where it is being analysed, or was not seen in this run
    bool analyse_again(const std::string& path);

    /// Files that are due to be looked at; answer each by see_file() or lose_file().
    std::vector<std::string> files_to_look_at(Time now) const;

    /// The actions to perform now, in this order. Each is given once.
    std::vector<Action> next_actions(Time now);

    /// The latest time at which files_to_look_at() or next_actions() will have something new.
    std::optional<Time> next_wake() const;

    /// All files known under this folder ("" for all, else without a '/' at the end).
    std::vector<std::string> paths_below(const std::string& folder) const;

    /// The progress of a file.
    enum class Progress {
        settling,  // not quiet yet
        waiting,   // incomplete when last tried
        due,       // to be analysed, or being analysed without anything in the catalogue
        growing,   // being analysed, with a part in the catalogue
        done,      // its record stands
    };

    /// @param since  the time at which it was done, else at which its content was first seen
    using Visit = std::function<void(const std::string& path, Progress progress, Time since)>;

    /// Calls with each file that was seen in this run, in the order of their paths.
    void visit_files(const Visit& call) const;

    /// True where nothing runs, and nothing will except retries of waiting files.
    bool is_idle() const;

  private:
    enum class Phase {
        unseen,  // only an earlier run has seen it; its record holds while it is the same
        stale,   // likewise, but it is to be analysed anew
        settling,
        due,
        running,
        done,
    };

    /// The record that the catalogue has of a path.
    enum class Recorded {
        no,
        waiting,  // the file waits
        part,     // the shots so far of the running analysis
        yes,      // another, perhaps of older content
    };

    struct Entry {
        FileFacts facts;
        Phase phase = Phase::unseen;
        Time look_at{};     // settling only
        Time since{};       // it is done, else has this content
        Attempts attempts;  // of the content as it is
        Recorded recorded = Recorded::no;
        bool is_remote = false;  // it is on a share
    };

    static Progress progress_of(const Entry& entry);
    static void end_part(Entry& entry);
    void enter_phase(const std::string& path, Entry& entry, Phase phase);
    void see_new_file(const std::string& path, const FileFacts& facts, LookKind look, Time now);
    void settle_file(const std::string& path, Entry& entry, std::chrono::nanoseconds delay, Time now);
    void see_change(const std::string& path, Entry& entry, const FileFacts& facts,
                    std::chrono::nanoseconds delay, Time now);
    void start_due_files();

    Pace pace_;
    std::map<std::string, Entry> entries_;
    LeavingFiles leaving_;
    AnalysisSlots slots_;                                 // files with a child, also a stopped one
    std::set<std::pair<Time, std::string>> looks_;        // the settling entries by their time
    std::set<std::pair<std::int64_t, std::string>> due_;  // the due entries by mtime
    std::vector<Action> actions_;
};

}  // namespace vitrine::analyzer
