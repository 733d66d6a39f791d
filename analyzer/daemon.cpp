#include "analyzer/daemon.hpp"

#include "base/catalogue/blame.hpp"
#include "base/catalogue/record_json.hpp"
#include "base/system/error.hpp"
#include "base/system/journal.hpp"
#include "base/system/service.hpp"

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/file.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto remote_rescan = 10s;  // the kernel reports nothing of a network share
constexpr auto offline_rescan = 5s;  // until the media folder is there
constexpr auto growth_rest = 500ms;  // between two writings of films whose analysis goes on
constexpr auto hint_rest = 300ms;    // in which a .vitrine.toml is written to its end

Schedule::Time now() {
    return EventLoop::Clock::now();
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
      status_(loop, options.root, options.status_folder, options.state, [this] { return report(); }) {
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
    load_catalogue();
    rescan();
    wake_.arm(0s);
    if (const auto interval = service::watchdog_interval()) {
        watchdog_ = loop_.timer([this, interval] {
            service::alive();
            watchdog_.arm(*interval / 2);
        });
        watchdog_.arm(0s);
    }
}

Daemon::~Daemon() = default;

void Daemon::load_catalogue() {
    const auto records = catalogue_.load([](const std::string& file, const std::string& reason) {
        log::warning("record '{}' unreadable, its file is analysed again: {}", file, reason);
        std::error_code ignored;  // it is overwritten at the latest
        fs::remove(file, ignored);
    });
    for (const MediaRecord& record : records) {
        const bool is_waiting = record.state == MediaState::waiting;
        schedule_.known(record.path, {.bytes = record.bytes, .mtime_ns = record.mtime_ns},
                        !is_waiting && record.is_complete && !store_.lacks(record), is_waiting);
        store_.hold(record);
        states_.hold(record);
        if (!record.is_complete) growing_.known(record);
    }
}

void Daemon::rescan() {
    const std::vector<std::string> remarks = follower_.rescan(now());
    for (const std::string& remark : remarks)
        if (std::find(remarks_.begin(), remarks_.end(), remark) == remarks_.end()) log::warning("{}", remark);
    if (!remarks_.empty() && remarks.empty()) log::info("the media folder is there, all of it can be read");
    remarks_ = remarks;
    for (const auto& [path, record] : std::exchange(unsaved_, {}))
        store(record);
    if (unsaved_.empty() && std::exchange(is_lack_told_, false)) log::info("all records are stored again");
    follow_blame();
    store_.sweep();
    read_hints();
    std::chrono::milliseconds interval = options_.rescan;
    if (folder_.is_remote()) interval = std::min<std::chrono::milliseconds>(interval, remote_rescan);
    if (!is_online()) interval = std::min<std::chrono::milliseconds>(interval, offline_rescan);
    rescan_.arm(interval);
}

void Daemon::read_hints() {
    if (is_online()) hint_files_.read(schedule_.paths_below(""));
    status_.touch();
}

/// Whatever happened ends here: the schedule says what follows.
void Daemon::advance() {
    follower_.look_at(schedule_.to_look_at(now()), now());
    for (std::vector<Action> actions = schedule_.step(now()); !actions.empty();
         actions = schedule_.step(now()))
        for (const Action& action : actions)
            perform(action);
    if (store_.is_over()) make_room();
    if (const auto time = schedule_.wake()) wake_.arm(*time - now());
    service::status(status());
    status_.touch();
    if (!options_.is_once || !schedule_.is_idle()) return;
    store_.sweep();
    status_.write();
    loop_.quit();
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
        unsaved_.erase(action.path);
        growing_.end(action.path);
        store_.release(action.path);
        states_.release(action.path);
        told_waiting_.erase(action.path);
        return catalogue_.remove(action.path);
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
    command.push_back(folder_.absolute(action.path).string());
    const ChildLimits limits =
        limits_for(options_.limits, options_.deadline_per_mebibyte, action.facts.bytes);
    log::debug("analysing '{}'", action.path);
    growing_.begin(record_of(action.path, action.facts, MediaState::waiting, ""));
    store_.begin(store_id(action.path, action.facts.bytes, action.facts.mtime_ns));
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
        if (schedule_.grew(record.path)) store(record);
    is_growth_resting_ = true;
    growth_.arm(growth_rest);
}

void Daemon::finish(const std::string& path, const FileFacts& facts, const ChildResult& result,
                    const ChildLimits& limits) {
    children_.erase(path);
    store_.end(store_id(path, facts.bytes, facts.mtime_ns));
    follower_.look_at(std::vector{path}, now());  // an answer to what the file was is worth nothing
    store_growth();
    answer(outcome_of(result, limits, path, facts));
    advance();
}

void Daemon::answer(Outcome outcome) {
    MediaRecord& record = outcome.record;
    switch (schedule_.finished(record.path, outcome.answer, now())) {
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

void Daemon::tell(const MediaRecord& record) {
    ++analysed_;
    if (options_.is_once) {
        const Schedule::Counts counts = schedule_.counts();
        log::info("analysed {} of {}: {}", analysed_,
                  analysed_ + counts.settling + counts.due + counts.running, record.path);
    }
    if (record.state != MediaState::ready)
        log::write_with(log::Level::warning,
                        fmt::format("{}: '{}': {}", name_of(record.state), record.path, record.reason),
                        journal_fields(record));
    else if (!record.reason.empty())
        log::warning("ready: '{}': {}", record.path, record.reason);
    else if (!options_.is_once)
        log::info("ready: '{}'", record.path);
}

/// A record that was damaged meanwhile is missed until the next start, which finds its file unknown.
void Daemon::move(const Action& action) {
    std::optional<MediaRecord> record = stored(action.from);
    if (!record) return log::warning("renamed without a record: '{}'", action.path);
    record->path = action.path;
    store(*record);
    catalogue_.remove(action.from);
    store_.release(action.from);
    states_.release(action.from);
    std::error_code none;  // only a picture for the status folder
    fs::rename(thumbnail(action.from), thumbnail(action.path), none);
    log::info("renamed: '{}' to '{}'", action.from, action.path);
}

std::optional<MediaRecord> Daemon::stored(const std::string& path) const {
    try {
        return catalogue_.find(path);
    } catch (const std::runtime_error& error) {  // loading one record
        log::warning("record of '{}' unreadable, ignoring: {}", path, error.what());
        return std::nullopt;
    }
}

/// What brings the player down is not shown, until it changes.
void Daemon::follow_blame() {
    const Blame blame = read_blame(options_.catalogue.parent_path());
    for (const std::string& path : suspects(blame, schedule_.paths_below(""))) {
        const std::optional<MediaRecord> record = stored(path);
        if (!record || record->state != MediaState::ready || !is_quarantined(blame, *record)) continue;
        const FileFacts facts{.bytes = record->bytes, .mtime_ns = record->mtime_ns};
        store(record_of(path, facts, MediaState::quarantined, brought_the_player_down));
        log::warning("quarantined: '{}': {}", path, brought_the_player_down);
    }
}

/// What lost its place in the store is played from the media folder.
void Daemon::make_room() {
    const std::set<std::string> paths = store_.make_room();
    for (const std::string& path : paths)
        if (const std::optional<MediaRecord> record = stored(path)) store(*record);
    if (!paths.empty())
        log::info("the store is full: {} files lose their place or a part of it", paths.size());
}

/// A full disk is no reason to stop: the record waits here.
void Daemon::store(MediaRecord record) {
    store_.mark_dropped(record);
    store_.hold(record);
    states_.hold(record);
    try {
        catalogue_.store(record);
        unsaved_.erase(record.path);
    } catch (const std::system_error& error) {
        if (!std::exchange(is_lack_told_, true))
            log::error("records cannot be stored, trying again: {}", error.what());
        unsaved_[record.path] = record;
    }
}

}  // namespace vitrine
