#include "player/content/visible_files.hpp"

#include "base/system/journal.hpp"
#include "player/input/rehearsal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr const char* one_after_the_other =
    "several files may have caused it; they are shown again one after another";

bool is_same_content(const MediaRecord& a, const MediaRecord& b) {
    return a.path == b.path && a.bytes == b.bytes && a.mtime_ns == b.mtime_ns;
}

std::chrono::sys_seconds clock() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

bool is_in(const std::string& path, const std::string& folder) {
    return folder.empty() || path.starts_with(folder + "/");
}

/// The last filters: is the file's folder shown on a screen, and does that screen choose the file?
Visibility judge_folder(const WallContent& content, const std::string& path) {
    if (content.is_off) return Visibility::screens_off;
    const auto is_shown = [&](const ShownFolder& shown) { return is_in(path, shown.folder); };
    const auto is_open = [&](const ShownFolder& shown) {
        return is_shown(shown) && is_in(path, shown.opened);
    };
    const auto is_chosen = [&](const ShownFolder& shown) {
        return is_open(shown) && !shown.avoided.contains(path);
    };
    if (content.folders.empty() || std::ranges::any_of(content.folders, is_chosen))
        return Visibility::waits_for_turn;
    if (std::ranges::any_of(content.folders, is_open)) return Visibility::avoided;
    return std::ranges::any_of(content.folders, is_shown) ? Visibility::closed_folder
                                                          : Visibility::other_folder;
}

/// Words for the ready files that the filters keep off the wall: ", 3 out of hours". @param kept_off  their
/// number
std::string reasons_in(const std::map<Visibility, std::size_t>& counts, std::size_t& kept_off) {
    std::string reasons;
    for (const auto& [visibility, count] : counts) {
        const bool is_ready = visibility != Visibility::not_analysed && visibility != Visibility::unsupported;
        if (may_be_shown(visibility) || !is_ready || count == 0) continue;
        reasons += fmt::format(", {} {}", count, in_short(visibility));
        kept_off += count;
    }
    return reasons;
}

/// Judges a file by the notices, too, if no other filter keeps it off the wall.
FileVisibility judge_by(const Notices& notices, FileVisibility judged) {
    if (!may_be_shown(judged.visibility)) return judged;
    if (notices.is_over(judged.path)) {
        judged.visibility = Visibility::notice_over;
    } else if (notices.is_covered(judged.path)) {
        judged.visibility = Visibility::covered;
        judged.detail = notices.active();
    }
    return judged;
}

void log_change(const CatalogueChange& change) {
    for (const std::string& path : change.added)
        log::write_with(log::Level::info, fmt::format("new: '{}'", path), {{"VITRINE_FILE", path}});
    for (const std::string& path : change.grown)
        log::debug("further shots: '{}'", path);
    for (const std::string& path : change.replaced)
        log::info("replaced: '{}'", path);
    for (const std::string& path : change.gone)
        log::write_with(log::Level::info, fmt::format("gone: '{}'", path), {{"VITRINE_FILE", path}});
}

}  // namespace

VisibleFiles::VisibleFiles(EventLoop& loop, const fs::path& state, const ShowDays& days,
                           const Rehearsal* rehearsal, std::function<void()> on_change)
    : rehearsal_(rehearsal),
      on_change_(std::move(on_change)),
      crash_note_(state),
      notices_(rehearsal == nullptr ? state / "notices" : fs::path()),
      hours_(state, days),
      judged_([this](const MediaRecord& file) {
          FileVisibility judged = judge_by(notices_, judge_file(file));
          if (may_be_shown(judged.visibility)) judged.visibility = judge_folder(content_, file.path);
          return judged;
      }),
      note_(rehearsal == nullptr ? state / visible_file : fs::path()),
      follower_(loop, Catalogue(state / "catalogue"),
                [this](const CatalogueChange& change, const RecordList& records, const GroupList& groups) {
                    hints_.groups = groups;
                    follow_catalogue(change, records);
                }) {}

FileVisibility VisibleFiles::judge_file(const MediaRecord& file) const {
    const std::string& path = file.path;
    const auto because = [&](Visibility visibility, std::string detail = {}) {
        return FileVisibility{.path = path, .visibility = visibility, .detail = std::move(detail)};
    };
    const bool is_open = hours_.is_open(path);
    if (file.state == MediaState::waiting) return because(Visibility::not_analysed, file.reason);
    if (!is_ready(file)) return because(Visibility::unsupported, file.reason);
    if (rehearsal_ != nullptr && !rehearsal_->is_present(path)) return because(Visibility::not_rehearsed);
    if (crash_note_.is_quarantined(file)) return because(Visibility::held_back, brought_the_player_down);
    if (crash_note_.is_on_hold(file)) return because(Visibility::held_back, one_after_the_other);
    if (dismissed_.contains(path)) return because(Visibility::dismissed);
    if (!is_open && !hours_.has_time()) return because(Visibility::no_clock, hours_.hours_of(path));
    if (!is_open) return because(Visibility::out_of_hours, hours_.hours_of(path));
    return because(Visibility::waits_for_turn);
}

FileVisibility VisibleFiles::judge(const MediaRecord& file) const {
    FileVisibility judged = judge_by(notices_, judge_file(file));
    if (!may_be_shown(judged.visibility)) return judged;
    judged.visibility = judge_folder(content_, file.path);
    return seen_on(std::move(judged), content_.files, hints_.groups, Moments(ready_));
}

void VisibleFiles::follow_catalogue(const CatalogueChange& change, const RecordList& records) {
    log_change(change);
    std::set<std::string> changed;
    RecordList::Changes ready;
    records.for_each_change(records_, [&](const RecordList::Record& before, const RecordList::Record& now) {
        const std::string& path = (now ? now : before)->path;
        changed.insert(path);
        ready[path] = now && is_ready(*now) ? now : nullptr;
    });
    records_ = records;
    ready_.apply(ready);
    // A dismissal ends when the file has changed or is gone.
    std::erase_if(dismissed_, [&](const auto& dismissed) {
        const RecordList::Record now = records_.find(dismissed.first);
        return !now || !is_same_content(*now, *dismissed.second);
    });
    judge_again(std::move(changed));
}

void VisibleFiles::apply_filters() {
    judge_again(std::nullopt);
}

/// Judges these files, and those whose hours have begun or ended. Files whose folder no screen shows stay in
/// the list: the screen may come at any time.
/// @param paths  none: all files
void VisibleFiles::judge_again(std::optional<std::set<std::string>> paths) {
    const bool is_other_trial = crash_note_.set_files(ready_);
    hours_.set_files(ready_);
    (void)hours_.look(rehearsal_ != nullptr ? rehearsal_->local_time() : std::nullopt);
    const auto can_be_shown = [this](const MediaRecord& file) {
        return may_be_shown(judge_file(file).visibility);
    };
    const bool is_other_notice = notices_.set_files(ready_, can_be_shown, clock());
    std::set<std::string> by_hours = hours_.take_changed();
    const auto today = hours_.today();
    const bool has_other_hints = !by_hours.empty() || today != hints_.today;
    GroupList groups = std::move(hints_.groups);
    hints_ = hours_.hints();
    hints_.groups = std::move(groups);
    hints_.today = today;
    if (paths) paths->merge(by_hours);
    const bool is_other = is_other_trial || is_other_notice || !paths ? judged_.judge_all(records_)
                                                                      : judged_.judge(*paths, records_);
    tell_change(is_other || has_other_hints);
}

/// Logs how many ready files the filters keep off the wall, if that has changed.
/// @param is_other  the list of files, or their hints, are others
void VisibleFiles::tell_change(bool is_other) {
    std::size_t kept_off = 0;
    std::string reasons = reasons_in(judged_.counts(), kept_off);
    if (reasons != logged_)
        log::info("files: {} of {} may be shown now{}", ready_.size() - kept_off, ready_.size(), reasons);
    logged_ = std::move(reasons);
    note_.set_changed();
    if (is_other) on_change_();
}

void VisibleFiles::look(std::chrono::nanoseconds time, Time now,
                        const std::function<WallContent()>& content) {
    if (time < next_look_) return;
    next_look_ = time + 1s;
    const bool is_other = hours_.look(rehearsal_ != nullptr ? rehearsal_->local_time() : std::nullopt);
    if (is_other || hours_.today() != hints_.today) judge_again(std::set<std::string>{});
    if (notices_.look(clock())) apply_filters();
    set_content(content());
    std::set<ContentName> open;
    for (const std::string& path : content_.open)
        if (const RecordList::Record record = records_.find(path)) open.insert(content_name(*record));
    if (crash_note_.note_open(open, now)) apply_filters();
    note_.write_if_due(now, [this] {
        return VisibleState{
            .files = judged_.all(), .on_wall = content_.files, .groups = hints_.groups, .records = ready_};
    });
}

void VisibleFiles::set_content(WallContent content) {
    if (content == content_) return;
    const bool has_other_folders = content.folders != content_.folders || content.is_off != content_.is_off;
    content_ = std::move(content);
    if (has_other_folders)
        tell_change(judged_.judge_all(records_));
    else
        note_.set_changed();
}

void VisibleFiles::set_dismissed(const std::set<std::string>& paths) {
    std::erase_if(dismissed_, [&](const auto& dismissed) { return !paths.contains(dismissed.first); });
    for (const std::string& path : paths)
        if (const RecordList::Record file = records_.find(path)) dismissed_.try_emplace(path, file);
    apply_filters();
}

void VisibleFiles::acquit(const std::string& path) {
    crash_note_.acquit(path);
    apply_filters();
}

std::vector<std::string> VisibleFiles::dismissed() const {
    std::vector<std::string> paths;
    for (const auto& [path, record] : dismissed_)
        paths.push_back(path);
    return paths;
}

void VisibleFiles::note_file(const std::string& path, FileNews news, Time now) {
    const RecordList::Record record = records_.find(path);
    if (!record) return;
    if (news == FileNews::opens)
        crash_note_.note_opening(*record, now);
    else
        crash_note_.note_reader_crash(*record, now);
}

void VisibleFiles::end_run() {
    crash_note_.end_run();
    note_.remove();
}

}  // namespace vitrine::player
