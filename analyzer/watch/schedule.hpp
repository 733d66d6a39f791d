#pragma once

#include "analyzer/watch/file_facts.hpp"

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// How the schedule waits. Times are the caller's monotonic clock.
struct Pace {
    std::size_t children = 1;                     // files analysed at the same time, at least 1
    std::uint64_t small_bytes = 0;                // one file up to this size is analysed beside them: photos
    std::chrono::milliseconds quiet{2000};        // a file must not have changed for so long
    std::chrono::milliseconds closed_quiet{150};  // where whoever wrote it has closed it, if that is shorter
    int remote_quiets = 3;  // as long on a network share, whose servers answer out of memory for a while
    std::chrono::milliseconds rename_grace{500};  // a vanished file may turn up under another name
    std::chrono::milliseconds first_retry{
        5000};        // after this a waiting file is tried again, then after twice
    int retries = 8;  // as long, ...; together 21 minutes
    int deaths = 2;   // children that one content may kill before quarantine
};

/// What is to be done to the catalogue and the children.
struct Action {
    enum class Kind {
        start,   // a child for `path`; finished() must follow
        stop,    // the child of `path`: its file changed or went; finished() must follow
        hold,    // the record of `path` becomes waiting: the file keeps changing
        move,    // the record of `from` is now that of `path`
        remove,  // the record of `path` goes
    };

    Kind kind = Kind::start;
    std::string path;
    std::string from;          // move only
    FileFacts facts;           // start and hold: what was seen of the file
    bool is_last_try = false;  // start only: no retry follows a waiting answer

    friend bool operator==(const Action&, const Action&) = default;
};

/// How it is known what a file is like.
enum class Sight {
    seen,    // looked at: somebody may be writing it
    closed,  // whoever wrote it has just closed it, or renamed it; some do so more than once
    remote,  // looked at over a network
};

/// How a child ended.
enum class Answer {
    final,    // ready, unsupported or failed: stands until the file changes
    waiting,  // incomplete: to be tried again
    died,     // a crash or the deadline
};

/// What becomes of a child's answer.
enum class Verdict {
    store,       // as it is
    give_up,     // store it as failed: it has waited long enough
    quarantine,  // store it as quarantined
    retry,       // nothing is stored yet
    discard,     // the file changed or went in the meantime
};

/// Decides which file is analysed when. Pure: sees no file and no clock, so that every order of events can be
/// tested.
///
/// seen -> settling (until unchanged for the quiet time) -> due -> running -> done; a change leads back to
/// settling from anywhere, a waiting answer too, with growing delays. A file is due only once it was looked
/// at again after its quiet time: to_look_at() says which, saw() or gone() is the answer.
class Schedule {
  public:
    using Time = std::chrono::steady_clock::time_point;

    explicit Schedule(const Pace& pace);

    /// A record that an earlier run left.
    /// @param is_settled  holds while the file is unchanged; else the file is analysed anew
    /// @param is_held     it is `waiting`
    void known(const std::string& path, const FileFacts& facts, bool is_settled, bool is_held);

    /// The file is there. Only what is seen here counts as quiet: the times that a file carries are those of
    /// clocks that are set, or of other machines.
    void saw(const std::string& path, const FileFacts& facts, Time now, Sight sight = Sight::seen);

    /// The file is not there. In a rename this comes before saw() of the new name.
    void gone(const std::string& path, Time now);

    /// The catalogue is about to have a record of a file that is still being analysed.
    /// @return whether it is: false where the file changed or went in the meantime
    bool grew(const std::string& path);

    Verdict finished(const std::string& path, Answer answer, Time now);

    /// A file whose record stands is analysed once more, for there is more to be known of it.
    void again(const std::string& path);

    /// Files whose time has come to be looked at, each to be answered by saw() or gone().
    std::vector<std::string> to_look_at(Time now) const;

    /// What to do now, in this order. Each action is given once.
    std::vector<Action> step(Time now);

    /// When to_look_at() or step() will have something new at the latest.
    std::optional<Time> wake() const;

    /// All files known under this folder ("" for all, else without a '/' at the end).
    std::vector<std::string> paths_below(const std::string& folder) const;

    /// How far a file has come.
    enum class Stage {
        settling,  // not quiet yet
        waiting,   // incomplete when last tried
        due,       // to be analysed, or being analysed without anything in the catalogue
        growing,   // being analysed, with a part in the catalogue
        done,      // its record stands
    };

    /// Calls with each file, in the order of their paths; `since`: when it was done, else when its content
    /// was first seen.
    using Visit = std::function<void(const std::string& path, Stage stage, Time since)>;

    void visit(const Visit& call) const;

    struct Counts {
        std::size_t files = 0, settling = 0, waiting = 0, due = 0, running = 0, done = 0;
    };

    Counts counts() const;

    /// Nothing runs, and nothing will except retries of waiting files.
    bool is_idle() const;

  private:
    enum class Phase { unseen, settling, due, running, done };

    struct Entry {
        FileFacts facts;
        Phase phase = Phase::unseen;
        Time look_at{};            // settling only
        Time since{};              // it is done, else has this content
        int deaths = 0;            // of the content as it is
        int waits = 0;             // waiting answers for the content as it is
        bool is_settled = false;   // unseen only
        bool is_recorded = false;  // the catalogue has a record of this path, perhaps of older content
        bool is_held = false;      // that record is waiting already
        bool has_grown = false;    // that record is a part of the running analysis
    };

    struct Leaving {
        FileFacts facts;
        bool is_done = false;  // its record holds for whoever has the same content
        Time forget_at{};
    };

    using Entries = std::map<std::string, Entry>;

    static Stage stage_of(const Entry& entry);
    std::chrono::milliseconds quiet(Sight sight) const;
    void enter(const std::string& path, Entry& entry, Phase phase);
    void saw_new(const std::string& path, const FileFacts& facts, std::chrono::nanoseconds delay, Time now);
    void settle(const std::string& path, Entry& entry, std::chrono::nanoseconds delay, Time now);
    void changed(const std::string& path, Entry& entry, const FileFacts& facts,
                 std::chrono::nanoseconds delay, Time now);
    bool take_over_from_leaving(const std::string& path, const FileFacts& facts);
    void forget_leaving(Time now);
    void start_due();
    bool has_room_for(const Entry& entry) const;

    Pace pace_;
    Entries entries_;
    std::map<std::string, Leaving> leaving_;              // gone, with a record that is still there
    std::set<std::string> children_;                      // files with a child, be it a stopped one
    std::set<std::pair<Time, std::string>> looks_;        // the settling entries by their time
    std::set<std::pair<std::int64_t, std::string>> due_;  // the due entries by mtime
    std::vector<Action> actions_;
};

}  // namespace vitrine::analyzer
