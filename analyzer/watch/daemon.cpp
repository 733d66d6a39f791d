#include "analyzer/watch/daemon.hpp"

#include "analyzer/lettering/folder_words.hpp"
#include "analyzer/status/plain_text.hpp"
#include "analyzer/status/status_text.hpp"
#include "analyzer/watch/fault_record.hpp"
#include "base/hints/hint_words.hpp"
#include "base/hints/notice.hpp"
#include "base/state/acquittal.hpp"
#include "base/state/blame.hpp"
#include "base/state/record_json.hpp"
#include "base/state/word_picture.hpp"
#include "base/system/journal.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>
#include <sys/epoll.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto remote_rescan = 10s;    // the kernel reports nothing of a network share
constexpr auto offline_rescan = 5s;    // until the media folder is there
constexpr auto unreachable_rest = 1s;  // until an unreachable file is looked at again
constexpr std::size_t words_a_child = 50;
constexpr auto weave_patience = 48h;  // a level may take hours without a sign of progress

constexpr const char* next_rescan = "rescan of the media folder";
constexpr const char* next_look = "look at a settling file";

Schedule::Time now() {
    return EventLoop::Clock::now();
}

/// The limits of a child that lets all others go first.
ChildLimits background_limits(const WatchOptions& options) {
    ChildLimits limits = options.analysis.limits;
    limits.niceness = 19;
    return limits;
}

WeaveOptions weave_options(const WatchOptions& options) {
    ChildLimits limits = background_limits(options);
    limits.patience = {.computing = weave_patience, .idling = weave_patience};
    return {.root = options.root,
            .state = options.state,
            .bounds = options.tapestries,
            .command = options.weave,
            .limits = limits};
}

RefineOptions refine_options(const WatchOptions& options) {
    return {.root = options.root,
            .command = options.refine,
            .limits = background_limits(options),
            .children = options.pace.children};
}

BookPlaces book_places(const WatchOptions& options) {
    return {.catalogue = options.catalogue,
            .store = options.store,
            .bounds = options.bounds,
            .thumbnails = options.state / "thumbnails"};
}

/// The folders in the media folder whose files are our own.
std::vector<std::string> passed_over(const WatchOptions& options) {
    std::vector<std::string> folders;
    if (!options.status_folder.empty()) folders.push_back(options.status_folder);
    const fs::path state = fs::absolute(options.state).lexically_normal().lexically_relative(options.root);
    if (state.empty() || *state.begin() == ".." || state == ".") return folders;
    folders.push_back(state.string());
    log::warning("the state directory lies in the media folder; '{}' is passed over", folders.back());
    return folders;
}

/// "3 of 12": the files that have been analysed, and all but those that wait for a retry.
std::string progress_in_words(const Schedule& schedule) {
    using Progress = Schedule::Progress;
    std::size_t done = 0;
    std::size_t all = 0;
    schedule.visit_files([&](const std::string&, Progress progress, Schedule::Time) {
        done += progress == Progress::done ? 1 : 0;
        all += progress != Progress::waiting ? 1 : 0;
    });
    return fmt::format("{} of {}", done, all);
}

/// @param is_free  nothing is to be analysed
WeaveScope weave_scope(bool may_weave, bool is_free) {
    if (!may_weave) return WeaveScope::none;
    return is_free ? WeaveScope::all : WeaveScope::wanted;
}

/// Has one file read again that an earlier version of the analysis looked at.
/// @return false where there is none
bool read_outdated_file(const FileStates& states, Schedule& schedule) {
    return std::ranges::any_of(states.outdated_files(),
                               [&](const std::string& path) { return schedule.analyse_again(path); });
}

std::vector<std::string> extended(std::vector<std::string> command, std::span<const std::string> arguments) {
    command.insert(command.end(), arguments.begin(), arguments.end());
    return command;
}

/// Has names of folders set as pictures, some at a time.
void request_words(MissingPictures& pictures, const WatchOptions& options,
                   const std::set<std::string>& names) {
    if (options.words_child.empty()) return;
    const std::vector<std::string> words = lacking_words(names, options.state);
    for (std::span<const std::string> rest(words); !rest.empty();) {
        const auto now_set = rest.first(std::min(rest.size(), words_a_child));
        pictures.request(extended(options.words_child, now_set));
        rest = rest.subspan(now_set.size());
    }
}

/// All captions that a file may have on the wall, in all their forms.
std::set<std::string> caption_keys(const WatchOptions& options, const std::string& path,
                                   const HintFiles& hints, const FileStates& states) {
    std::set<std::string> keys;
    if (options.words.captions == CaptionChoice::none) return keys;
    const std::string written = hints.hints_for(path).caption.value_or("");
    const FileStates::OwnCaption own = states.caption(path);
    const bool uses_names = options.words.captions == CaptionChoice::names;
    CaptionSources sources{
        .written = written, .own = own.text, .path = uses_names ? std::string_view(path) : ""};
    const auto add = [&] {
        const std::string caption = caption_of(sources);
        for (int lines = 1; lines <= caption_forms && !caption.empty(); ++lines)
            keys.insert(caption_key(caption, lines));
    };
    add();
    if (!options.words.tells_years || !own.day) return keys;
    sources.day = own.day;
    add();
    return keys;
}

/// Has the names of all folders, all captions and QR codes set, and removes other words.
void set_all_words(MissingPictures& pictures, const WatchOptions& options,
                   const std::vector<std::string>& paths, const HintFiles& hints, const FileStates& states) {
    std::set<std::string> words = shown_folder_names(paths);
    if (!options.words.wall_code.empty()) words.insert(code_key(options.words.wall_code));
    if (!options.words.share_address.empty()) words.insert(options.words.share_address);
    for (const std::string& path : paths) {
        if (const auto code = hints.hints_for(path).code) words.insert(code_key(*code));
        words.merge(caption_keys(options, path, hints, states));
    }
    remove_other_words(words, options.state);
    request_words(pictures, options, words);
}

/// True if the network has seen the photo as it is.
bool is_refined(const std::optional<MediaRecord>& known, const FileFacts& facts) {
    return known && known->bytes == facts.bytes && known->mtime_ns == facts.mtime_ns &&
           known->shots.size() == 1 && known->shots.front().certainty;
}

/// True for a notice's file that is read quickly. It is seen sooner if the first analysis makes no copy in
/// the store, as the player plays it from the media folder meanwhile. A second one makes the copy, which the
/// other boxes of a wall need.
bool comes_before_copy(const WatchOptions& options, const std::string& path, std::uint64_t bytes) {
    return options.outputs.stored && notice_named(path) && bytes <= options.pace.small_bytes;
}

/// True if the record is that of a whole file with this content.
bool is_record_of(const std::optional<MediaRecord>& record, const FileFacts& facts) {
    return record && record->state == MediaState::ready && record->is_complete &&
           record->bytes == facts.bytes && record->mtime_ns == facts.mtime_ns;
}

/// The record of a file that brought its readers down: quarantined, or a film that is shown as far as it is
/// known.
/// @param known  the record in the catalogue
MediaRecord record_after_deaths(AnalysisOutcome outcome, const std::optional<MediaRecord>& known) {
    outcome.record.reason = "twice " + outcome.record.reason;
    std::optional<MediaRecord> kept = kept_record(known, outcome);
    return kept ? std::move(*kept) : quarantined_record(outcome.record, known, WallClock::now());
}

/// @param is_once  the run tells how far it is
void log_record(const MediaRecord& record, bool is_once, const Schedule& schedule) {
    if (is_once) log::info("analysed {}: {}", progress_in_words(schedule), record.path);
    if (record.state != MediaState::ready)
        log::write_with(log::Level::warning,
                        fmt::format("{}: '{}': {}", name_of(record.state), record.path, record.reason),
                        journal_fields(record));
    else if (!record.reason.empty())
        log::warning("ready: '{}': {}", record.path, record.reason);
    else if (!is_once)
        log::info("ready: '{}'", record.path);
}

}  // namespace

Daemon::Daemon(EventLoop& loop, const WatchOptions& options)
    : loop_(loop),
      options_(options),
      schedule_(options.pace),
      liveness_(loop,
                [this] {
                    return StatusLine{status(), !analyses_.is_idle()};
                }),
      follower_(MediaFolder(options.root, passed_over(options)), schedule_),
      hint_files_(loop, follower_.folder(), options.state / "hints.json", [this] { follow_hints(); }),
      weaver_(loop, weave_options(options), [this] { wake_.arm(0s); }),
      refiner_(loop, refine_options(options),
               [this](const std::vector<MediaRecord>& records) {
                   book_.refine(records);
                   wake_.arm(0s);
               }),
      book_(loop, book_places(options), schedule_, {.weaver = weaver_, .refiner = refiner_}),
      analyses_(loop, options.analysis,
                {.grown = [this](const MediaRecord& part) { book_.add_growth(part); },
                 .ended = [this](const FileFacts& facts,
                                 const AnalysisOutcome& outcome) { finish_analysis(facts, outcome); }}),
      status_(loop, options.root, options.status_folder, options.state, [this] { return report(); }),
      pictures_(loop, options.analysis.limits, [this] { wake_.arm(0s); }) {
    events_ = loop_.watch(follower_.fd(), EPOLLIN, [this](std::uint32_t) {
        attempt([this] {
            if (follower_.read_events(now())) rescan();
            if (follower_.take_hint_news()) hint_files_.read_soon();
            advance();
        });
    });
    wake_ = loop_.timer([this] { attempt([this] { advance(); }); });
    const auto look_again = [this] {
        rescan();
        advance();
    };
    rescan_ = loop_.timer([this, look_again] { attempt(look_again); });
    book_.load();
    attempt([this] { rescan(); });
    wake_.arm(0s);
}

void Daemon::change_words(WordSettings words) {
    options_.words = std::move(words);
    attempt([this] { follow_hints(); });
}

bool Daemon::is_up_to_date() const {
    const auto [records, removals] = book_.backlog();
    return is_online() && records + removals == 0;
}

/// The media folder, its share and this machine may fail in any way: the daemon goes on, and reads the folder
/// again.
void Daemon::attempt(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::system_error& error) {
        if (follower_.note_failure(error.what())) log::error("{}; trying again", error.what());
        rescan_.arm(offline_rescan);
        liveness_.expect(next_rescan, now() + offline_rescan);
        liveness_.meet(next_look);
    }
}

void Daemon::rescan() {
    const std::vector<std::string> before = follower_.remarks();
    follower_.rescan(now(), [this] { liveness_.feed_watchdog_now(); });
    const std::vector<std::string>& remarks = follower_.remarks();
    for (const std::string& remark : remarks)
        if (std::find(before.begin(), before.end(), remark) == before.end()) log::warning("{}", remark);
    if (!before.empty() && remarks.empty()) log::info("the media folder is there and can be read as a whole");
    book_.retry_writes();
    quarantine_suspects();
    end_quarantines();
    const std::vector<std::string> paths = schedule_.paths_below("");
    book_.sweep(paths);
    follow_hints();
    std::chrono::milliseconds interval = options_.rescan;
    if (follower_.folder().is_remote())
        interval = std::min<std::chrono::milliseconds>(interval, remote_rescan);
    if (!is_online()) interval = std::min<std::chrono::milliseconds>(interval, offline_rescan);
    rescan_.arm(interval);
    liveness_.expect(next_rescan, now() + interval);
}

/// Names or folders may say something else now. A film that is to be heard from now on may lack its sound.
void Daemon::follow_hints() {
    if (is_online()) {
        const std::vector<std::string> paths = schedule_.paths_below("");
        hint_files_.read(paths, follower_.sidecars());
        weaver_.set_choices(hint_files_.keyframe_choices());
        set_all_words(pictures_, options_, paths, hint_files_, book_.states());
        const auto is_heard = [this](const std::string& path) {
            return hint_files_.hints_for(path).sound.value_or(false);
        };
        if (book_.request_sounds(paths, is_heard)) wake_.arm(0s);
    }
    status_.touch();
}

/// A file that brings the player down is not shown until it changes.
void Daemon::quarantine_suspects() {
    const Blame blame = read_blame(options_.state);
    for (const std::string& path : suspects(blame, schedule_.paths_below(""))) {
        const std::optional<MediaRecord> record = book_.record(path);
        if (!record || record->state != MediaState::ready) continue;
        const auto now_s = std::chrono::floor<std::chrono::seconds>(WallClock::now().time_since_epoch());
        const std::optional<Suspicion> quarantine = find_quarantine(blame, *record, now_s);
        if (!quarantine) continue;
        const FileFacts facts{.bytes = record->bytes, .mtime_ns = record->mtime_ns};
        MediaRecord judged = record_of(path, facts, MediaState::quarantined, brought_the_player_down);
        judged.fault = {.owner = FaultOwner::file,
                        .since = quarantine->since,
                        .until = quarantine->since + quarantine_time(quarantine->quarantines),
                        .quarantines = quarantine->quarantines};
        book_.store(judged);
        log::warning("quarantined: '{}': {}", path, brought_the_player_down);
    }
}

/// A file whose quarantine is over is analysed anew. A folder that is not there says nothing.
void Daemon::end_quarantines() {
    if (!is_online()) return;
    const Acquittals acquittals = read_acquittals(options_.state);
    const auto is_over = [&](const std::string& path, const Fault& quarantine) {
        return WallClock::now().time_since_epoch() >= quarantine.until ||
               is_acquitted(acquittals, path, quarantine);
    };
    for (const std::string& path : book_.states().quarantined_files(is_over)) {
        log::info("its quarantine is over: '{}'", path);
        schedule_.analyse_again(path);
    }
}

/// Every event ends here: the schedule decides what follows.
void Daemon::advance() {
    const Schedule::Time begin = now();
    follower_.look_at(schedule_.files_to_look_at(begin), begin);
    for (std::vector<Action> actions = schedule_.next_actions(now()); !actions.empty();
         actions = schedule_.next_actions(now()))
        for (const Action& action : actions)
            perform(action);
    bool is_free = is_online() && schedule_.is_idle();
    refiner_.advance(is_free);
    is_free = is_free && refiner_.backlog() == 0;
    if (is_free && read_outdated_file(book_.states(), schedule_)) return wake_.arm(0s);
    weaver_.advance(weave_scope(is_online() && options_.weaves, is_free));
    book_.make_room();
    wake_at(schedule_.next_wake(), begin);
    liveness_.send_status_soon();
    status_.touch();
    if (!schedule_.is_idle()) return;
    if (!options_.is_once) return request_thumbnails();
    if (is_online() && (refiner_.backlog() > 0 || (options_.weaves && !weaver_.is_idle()))) return;
    if (!pictures_.is_idle()) return;
    book_.sweep(schedule_.paths_below(""));
    status_.write();
    loop_.quit();
}

/// A file that was due and still is could not be reached: it is tried again after a while.
void Daemon::wake_at(std::optional<Schedule::Time> time, Schedule::Time begin) {
    liveness_.meet(next_look);
    if (!time) return;
    const Schedule::Time at = *time <= begin ? now() + unreachable_rest : *time;
    wake_.arm(std::max<Schedule::Time::duration>(at - now(), 0s));
    liveness_.expect(next_look, at);
}

void Daemon::perform(const Action& action) {
    switch (action.kind) {
    case Action::Kind::start:
        return start_analysis(action);
    case Action::Kind::stop:
        return analyses_.stop(action.path);
    case Action::Kind::hold:
        return book_.store(
            record_of(action.path, action.facts, MediaState::waiting, "it is still being copied"));
    case Action::Kind::move:
        if (!book_.move(action.from, action.path))
            return log::warning("renamed, but its record is missing: '{}'", action.path);
        hint_files_.read_soon();  // the new name may say something else
        request_words(pictures_, options_, shown_folder_names(std::array{action.path}));
        return log::info("renamed: '{}' to '{}'", action.from, action.path);
    case Action::Kind::remove:
        log::info("gone: '{}'", action.path);
        return book_.remove(action.path);
    }
}

void Daemon::start_analysis(const Action& action) {
    const auto wait = [&](const char* reason) {
        store_answer({.answer = Answer::waiting,
                      .record = record_of(action.path, action.facts, MediaState::waiting, reason)});
    };
    if (!action.facts.is_readable) return wait("it may not be read: its permissions forbid it");
    if (!action.is_last_try && follower_.folder().ends_in_hole(action.path))
        return wait("the copy is not complete: parts of the file are still empty");
    AnalysisOutputs outputs = options_.outputs;
    if (comes_before_copy(options_, action.path, action.facts.bytes))
        outputs.stored = is_record_of(book_.record(action.path), action.facts);
    outputs.sound = outputs.stored && hint_files_.hints_for(action.path).sound.value_or(false);
    outputs.accepts_cut = action.is_last_try;
    // The plain region for a while, in the place of the network's, would move the wall twice.
    outputs.network = !options_.refine.empty() && is_refined(book_.record(action.path), action.facts);
    std::vector<std::string> arguments = arguments_for(outputs);
    arguments.push_back(follower_.folder().absolute(action.path).string());
    request_words(pictures_, options_, shown_folder_names(std::array{action.path}));
    book_.begin_analysis(action.path, action.facts);
    try {
        analyses_.start(action.path, action.facts, arguments);
    } catch (const std::system_error& error) {  // no memory, no descriptor, no process
        book_.end_analysis(action.path, action.facts);
        AnalysisOutcome outcome{.answer = Answer::postponed,
                                .record =
                                    record_of(action.path, action.facts, MediaState::waiting, error.what())};
        outcome.record.fault.owner = FaultOwner::machine;
        store_answer(std::move(outcome));
    }
}

void Daemon::finish_analysis(const FileFacts& facts, const AnalysisOutcome& outcome) {
    const std::string& path = outcome.record.path;
    follower_.look_at(std::vector{path}, now());  // an answer about an older content is discarded
    book_.end_analysis(path, facts);
    store_answer(outcome);
    attempt([this] { advance(); });
}

void Daemon::store_answer(AnalysisOutcome outcome) {
    MediaRecord& record = outcome.record;
    switch (schedule_.finish_analysis(record.path, outcome.answer, now())) {
    case Verdict::discard:
        return;
    case Verdict::retry:
        return log::warning("will be tried again: '{}': {}", record.path, record.reason);
    case Verdict::postpone:
        return postpone(std::move(record));
    case Verdict::give_up:
        record.state = MediaState::failed;
        break;
    case Verdict::quarantine:
        record = record_after_deaths(outcome, book_.record(record.path));
        break;
    case Verdict::store:
        break;
    }
    const bool lacks_copy =
        comes_before_copy(options_, record.path, record.bytes) &&
        !is_record_of(book_.record(record.path), {.bytes = record.bytes, .mtime_ns = record.mtime_ns});
    book_.store(record);
    if (lacks_copy && record.state == MediaState::ready) schedule_.analyse_again(record.path);
    request_words(pictures_, options_, caption_keys(options_, record.path, hint_files_, book_.states()));
    if (book_.is_news(record)) log_record(record, options_.is_once, schedule_);
}

/// A record of the same content that holds stays: the wall goes on with it.
void Daemon::postpone(MediaRecord record) {
    const std::optional<MediaRecord> known = book_.record(record.path);
    if (known && known->state == MediaState::ready && is_same_content(*known, record)) return;
    if (record.fault.owner == FaultOwner::file) {
        record.fault.owner = FaultOwner::machine;
        record.reason =
            "readers of several files crashed within an hour, so this machine may be at fault; here " +
            record.reason;
    }
    record = waiting_record(std::move(record), known, WallClock::now());
    book_.store(record);
    if (book_.is_news(record)) log_record(record, options_.is_once, schedule_);
}

void Daemon::request_thumbnails() {
    if (!is_online() || options_.thumbnail_child.empty()) return;
    for (const std::string& path : status_.lacking())
        pictures_.request_once(
            extended(options_.thumbnail_child, std::array{follower_.folder().absolute(path).string()}));
}

std::string Daemon::status() const {
    const std::vector<std::string>& remarks = follower_.remarks();
    if (!is_online()) return remarks.empty() ? "starting" : plain_text(remarks.front());
    std::string text = summary(book_.states().counts(schedule_));
    if (!analyses_.is_idle()) text += "; " + analyses_.in_words();
    if (const std::size_t photos = refiner_.backlog(); photos > 0)
        text += fmt::format("; looking closer at {} photo{}", photos, photos == 1 ? "" : "s");
    if (const std::size_t files = book_.states().outdated_files().size(); files > 0)
        text +=
            fmt::format("; {} file{} of an earlier version to be read again", files, files == 1 ? "" : "s");
    if (const std::size_t records = book_.backlog().records; records > 0)
        text += fmt::format("; {} record{} cannot be stored: is the disk full?", records,
                            records == 1 ? "" : "s");
    if (!remarks.empty()) text += "; " + plain_text(remarks.front());
    return text;
}

std::vector<FileState> Daemon::files() const {
    return book_.states().list(schedule_, now(), std::chrono::system_clock::now());
}

StatusReport Daemon::report() const {
    StatusReport report{
        .remarks = hint_files_.faults(), .inbox = follower_.inbox(), .is_online = is_online()};
    report.remarks.insert(report.remarks.end(), follower_.remarks().begin(), follower_.remarks().end());
    for (FileState& file : files()) {
        Hints hints = hint_files_.hints_for(file.path);
        const FileStates::OwnCaption own = book_.states().caption(file.path);
        if (!hints.caption && !own.text.empty()) hints.caption = own.text;
        std::string id = record_id(file.path);
        KeyframeChoice keyframes = weaver_.keyframes_for(file.path);
        report.files.push_back({.file = std::move(file),
                                .hints = hints,
                                .keyframes = std::move(keyframes),
                                .id = std::move(id)});
    }
    return report;
}

}  // namespace vitrine::analyzer
