#include "analyzer/watch/daemon.hpp"

#include "base/system/error.hpp"
#include "base/system/log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/file.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto remote_rescan = 10s;    // the kernel reports nothing of a network share
constexpr auto offline_rescan = 5s;    // until the media folder is there
constexpr auto growth_rest = 500ms;    // between two writings of films whose analysis goes on
constexpr auto tell_rest = 1s;         // between two words to systemd
constexpr auto unreachable_rest = 1s;  // until what could not be looked at is looked at again
constexpr auto weave_deadline = 48h;   // it does nothing that could hang, but all others go first
constexpr auto hint_rest = 300ms;      // in which a .vitrine.toml is written to its end

Schedule::Time now() {
    return EventLoop::Clock::now();
}

std::string reading_of(const std::string& path) {
    return fmt::format("'{}' is read", path);
}

/// The catalogue has one writer.
UniqueFd lock_of(const fs::path& catalogue) {
    fs::create_directories(catalogue);
    const fs::path file = catalogue / "writer.lock";
    UniqueFd lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (!lock.is_open()) throw_errno("open '{}'", file.string());
    if (::flock(lock.get(), LOCK_EX | LOCK_NB) == 0) return lock;
    if (errno == EWOULDBLOCK) errno = EBUSY;
    throw_errno("another vitrine-analyzer writes the catalogue '{}'", catalogue.string());
}

WeaveOptions weave_options(const WatchOptions& options) {
    constexpr int niceness = 19;
    ChildLimits limits = options.limits;
    limits.deadline = weave_deadline;
    limits.niceness = niceness;
    return {.root = options.root,
            .state = options.state,
            .bounds = options.tapestries,
            .command = options.weave,
            .limits = limits};
}

}  // namespace

Daemon::Daemon(EventLoop& loop, const WatchOptions& options)
    : loop_(loop),
      options_(options),
      folder_(options.root, options.status_folder),
      catalogue_(options.catalogue),
      store_(options.store, options.bounds),
      lock_(lock_of(options.catalogue)),
      schedule_(options.pace),
      follower_(folder_, schedule_),
      hint_files_(folder_, options.state / "hints.json"),
      weaver_(loop, weave_options(options)),
      status_(loop, options.root, options.status_folder, options.state, [this] { return report(); }),
      thumbnails_(loop, options.thumbnail_child, options.limits, [this] { status_.touch(); }) {
    events_ = loop_.watch(follower_.fd(), EPOLLIN, [this](std::uint32_t) {
        if (follower_.read_events(now())) rescan();
        if (follower_.take_hint_news()) hints_.arm(hint_rest);
        advance();
    });
    wake_ = loop_.timer([this] { advance(); });
    rescan_ = loop_.timer([this] {
        rescan();
        advance();
    });
    growth_ = loop_.timer([this] {
        is_growth_resting_ = false;
        store_growth();
    });
    hints_ = loop_.timer([this] { read_hints(); });
    watchdog_ = loop_.timer([this] { feed_watchdog(); });
    telling_ = loop_.timer([this] { tell_systemd(); });
    load_catalogue();
    rescan();
    wake_.arm(0s);
    watchdog_.arm(0s);
}

Daemon::~Daemon() = default;

void Daemon::rescan() {
    const std::vector<std::string> remarks = follower_.rescan(now(), [this] { get_on(); });
    for (const std::string& remark : remarks)
        if (std::find(remarks_.begin(), remarks_.end(), remark) == remarks_.end()) log::warning("{}", remark);
    if (!remarks_.empty() && remarks.empty()) log::info("the media folder is there, all of it can be read");
    remarks_ = remarks;
    store_again();
    follow_blame();
    store_.sweep();
    weaver_.sweep(schedule_.paths_below(""));
    read_hints();
    std::chrono::milliseconds interval = options_.rescan;
    if (folder_.is_remote()) interval = std::min<std::chrono::milliseconds>(interval, remote_rescan);
    if (!is_online()) interval = std::min<std::chrono::milliseconds>(interval, offline_rescan);
    rescan_.arm(interval);
    pulse_.expect("the media folder is read", now() + interval);
}

/// Whatever happened ends here: the schedule says what follows.
void Daemon::advance() {
    const Schedule::Time begin = now();
    follower_.look_at(schedule_.files_to_look_at(begin), begin);
    for (std::vector<Action> actions = schedule_.next_actions(now()); !actions.empty();
         actions = schedule_.next_actions(now()))
        for (const Action& action : actions)
            perform(action);
    weaver_.advance(is_online() && schedule_.is_idle() && !options_.is_once);
    if (store_.is_over()) make_room();
    wake_at(schedule_.next_wake(), begin);
    if (!is_telling_) telling_.arm(tell_rest);
    is_telling_ = true;
    status_.touch();
    if (!schedule_.is_idle()) return;
    if (!options_.is_once) return make_thumbnails();
    store_.sweep();
    status_.write();
    loop_.quit();
}

/// What was to be looked at and still is could not be reached: it is tried again after a while.
void Daemon::wake_at(std::optional<Schedule::Time> time, Schedule::Time begin) {
    const std::string look = "files are looked at";
    pulse_.came(look);
    if (!time) return;
    const Schedule::Time at = *time <= begin ? now() + unreachable_rest : *time;
    wake_.arm(std::max<Schedule::Time::duration>(at - now(), 0s));
    pulse_.expect(look, at);
}

void Daemon::perform(const Action& action) {
    switch (action.kind) {
    case Action::Kind::start:
        return start(action);
    case Action::Kind::stop:
        return children_.at(action.path)->stop();
    case Action::Kind::hold:
        return store(record_of(action.path, action.facts, MediaState::waiting, "it is still being copied"));
    case Action::Kind::move:
        return move(action);
    case Action::Kind::remove:
        log::info("gone: '{}'", action.path);
        growing_.end(action.path);
        store_.release(action.path);
        states_.forget_file(action.path);
        weaver_.release(action.path);
        told_waiting_.erase(action.path);
        heard_.erase(action.path);
        return remove_record(action.path);
    }
}

void Daemon::start(const Action& action) {
    const auto wait = [&](const char* reason) {
        answer({.answer = Answer::waiting,
                .record = record_of(action.path, action.facts, MediaState::waiting, reason)});
    };
    if (!action.facts.is_readable) return wait("it may not be read: its permissions forbid it");
    if (!action.is_last_try && folder_.ends_in_hole(action.path))
        return wait("the copy is not complete: parts of the file are still empty");
    std::vector<std::string> command = options_.child;
    if (store_.is_on() && is_to_be_heard(action.path)) command.emplace_back("--sound");
    command.push_back(folder_.absolute(action.path).string());
    if (action.is_last_try) command.emplace_back("--as-it-is");
    const ChildLimits limits =
        limits_for(options_.limits, options_.deadline_per_mebibyte, action.facts.bytes);
    log::debug("analysing '{}'", action.path);
    growing_.begin(record_of(action.path, action.facts, MediaState::waiting, ""));
    store_.begin(store_id(action.path, action.facts.bytes, action.facts.mtime_ns));
    reading_[action.path] = now();
    pulse_.expect(reading_of(action.path), now() + limits.deadline);
    children_[action.path] = std::make_unique<ChildProcess>(
        loop_, command, limits,
        [this, path = action.path, facts = action.facts, limits](const ChildResult& result) {
            finish(path, facts, result, limits);
        },
        [this, path = action.path, facts = action.facts](const std::string& line) {
            grow(path, facts, line);
        });
}

/// The first shot of a film is on the wall while the rest of it is still looked at.
void Daemon::grow(const std::string& path, const FileFacts& facts, const std::string& line) {
    try {
        const std::optional<MediaRecord> part = growth_of(line, path, facts);
        if (!part) return;
        growing_.add(*part);
    } catch (const std::runtime_error& error) {  // loading one record
        return log::warning("a part of '{}' makes no sense, ignoring: {}", path, error.what());
    }
    if (!is_growth_resting_) store_growth();
}

void Daemon::store_growth() {
    if (!growing_.has_news()) return;
    for (const MediaRecord& record : growing_.take_news())
        if (schedule_.mark_grown(record.path)) store(record);
    is_growth_resting_ = true;
    growth_.arm(growth_rest);
}

void Daemon::finish(const std::string& path, const FileFacts& facts, const ChildResult& result,
                    const ChildLimits& limits) {
    children_.erase(path);
    reading_.erase(path);
    pulse_.came(reading_of(path));
    store_.end(store_id(path, facts.bytes, facts.mtime_ns));
    weaver_.analysed(path);
    follower_.look_at(std::vector{path}, now());  // an answer to what the file was is worth nothing
    store_growth();
    answer(outcome_of(result, limits, path, facts));
    advance();
}

void Daemon::answer(Outcome outcome) {
    MediaRecord& record = outcome.record;
    switch (schedule_.finish_analysis(record.path, outcome.answer, now())) {
    case Verdict::discard:
        return;
    case Verdict::retry:
        return log::warning("tried once more: '{}': {}", record.path, record.reason);
    case Verdict::give_up:
        record.state = MediaState::failed;
        break;
    case Verdict::quarantine:
        record.reason = "twice " + record.reason;
        if (auto known = kept(stored(record.path), outcome)) record = std::move(*known);
        break;
    case Verdict::store:
        break;
    }
    growing_.end(record.path);
    store(record);
    if (record.state != MediaState::waiting)
        told_waiting_.erase(record.path);
    else if (!told_waiting_.insert(record.path).second)
        return;  // it waits on
    tell(record);
}

}  // namespace vitrine::analyzer
