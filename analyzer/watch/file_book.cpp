#include "analyzer/watch/file_book.hpp"

#include "analyzer/watch/analysis_outcome.hpp"
#include "analyzer/watch/fault_record.hpp"
#include "base/state/former_names.hpp"
#include "base/system/error.hpp"
#include "base/system/log.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr auto growth_rest = std::chrono::milliseconds(500);  // between two writings of growing films

/// The growth of a film that the catalogue has whole: the wall keeps its shots while it is analysed again.
std::optional<FilmGrowth> known_growth(const std::optional<MediaRecord>& known) {
    if (!known || known->state != MediaState::ready) return std::nullopt;
    return FilmGrowth::published(*known);
}

/// True if a whole record of the same content had other bars.
bool had_other_bars(const std::optional<MediaRecord>& before, const MediaRecord& record) {
    return before && before->state == MediaState::ready && before->is_complete &&
           is_same_content(*before, record) && active_picture(*before) != active_picture(record);
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

FileBook::FileBook(EventLoop& loop, const BookPlaces& places, Schedule& schedule, RecordFollowers followers)
    : catalogue_(places.catalogue),
      lock_(lock_of(places.catalogue)),
      store_(places.store, places.bounds),
      schedule_(schedule),
      followers_(followers),
      thumbnails_(places.thumbnails),
      growth_(loop.timer([this] {
          is_growth_resting_ = false;
          publish_growth();
      })) {}

void FileBook::load() {
    rename_former(catalogue_.directory().parent_path());
    const auto records = catalogue_.load([](const std::string& file, const std::string& reason) {
        log::warning("record '{}' unreadable, its file is analysed again: {}", file, reason);
        std::error_code ignored;  // it is overwritten at the latest
        fs::remove(file, ignored);
    });
    for (const MediaRecord& record : records) {
        const bool is_waiting = record.state == MediaState::waiting;
        schedule_.add_recorded(record.path,
                               {.bytes = record.bytes, .mtime_ns = record.mtime_ns, .inode = record.inode},
                               !is_waiting && record.is_complete && !store_.lacks(record), is_waiting);
        store_.note_record(record);
        states_.note_record(record);
        followers_.weaver.note_record(record);
        followers_.refiner.note_record(record);
        if (!record.is_complete)
            files_[record.path].growth = std::make_unique<FilmGrowth>(FilmGrowth::published(record));
    }
}

std::optional<MediaRecord> FileBook::record(const std::string& path) const {
    try {
        return catalogue_.find(path);
    } catch (const std::runtime_error& error) {  // loading one record
        log::warning("record of '{}' unreadable, ignoring: {}", path, error.what());
        return std::nullopt;
    }
}

void FileBook::store(const MediaRecord& record) {
    if (const auto known = files_.find(record.path); known != files_.end()) known->second.growth.reset();
    if (had_other_bars(this->record(record.path), record))
        followers_.weaver.forget_film(record.path);  // its tapestry shows bars, or lacks a part
    write_record(record);
}

void FileBook::write_record(MediaRecord record) {
    store_.mark_dropped(record);
    store_.note_record(record);
    states_.note_record(record);
    followers_.weaver.note_record(record);
    followers_.refiner.note_record(record);
    const auto known = files_.find(record.path);
    if (known != files_.end()) known->second.is_unremoved = false;
    try {
        catalogue_.store(record);
        if (known != files_.end()) known->second.unstored.reset();
    } catch (const std::system_error& error) {
        if (!std::exchange(is_lack_told_, true))
            log::error("records cannot be stored, trying again: {}", error.what());
        std::unique_ptr<MediaRecord>& unstored = files_[record.path].unstored;
        unstored = std::make_unique<MediaRecord>(std::move(record));
    }
}

void FileBook::refine(const std::vector<MediaRecord>& found) {
    for (const MediaRecord& refined : found) {
        std::optional<MediaRecord> known = record(refined.path);
        if (!known || known->state != MediaState::ready || !is_same_content(*known, refined)) continue;
        if (known->shots.size() != 1 || refined.shots.size() != 1) continue;
        known->shots.front().region = refined.shots.front().region;
        known->shots.front().picture = refined.shots.front().picture;
        known->shots.front().marks = refined.shots.front().marks;
        known->shots.front().certainty = refined.shots.front().certainty;
        known->shots.front().analysis = refined.shots.front().analysis;
        write_record(std::move(*known));
    }
}

bool FileBook::move(const std::string& from, const std::string& to) {
    std::optional<MediaRecord> moved = record(from);
    if (!moved) return false;
    moved->path = to;
    followers_.weaver.rename_film(from, to);
    store(*moved);
    remove(from);
    std::error_code none;  // only a picture for the status folder
    fs::remove_all(thumbnails_ / record_id(to), none);
    fs::rename(thumbnails_ / record_id(from), thumbnails_ / record_id(to), none);
    return true;
}

void FileBook::remove(const std::string& path) {
    files_.erase(path);
    store_.forget_file(path);
    states_.forget_file(path);
    followers_.weaver.forget_film(path);
    followers_.refiner.forget_file(path);
    remove_record(path);
}

void FileBook::remove_record(const std::string& path) {
    try {
        catalogue_.remove(path);
    } catch (const fs::filesystem_error& error) {
        if (!std::exchange(is_lack_told_, true))
            log::error("records cannot be removed, trying again: {}", error.what());
        files_[path].is_unremoved = true;
    }
}

void FileBook::retry_writes() {
    std::vector<MediaRecord> unstored;
    std::vector<std::string> unremoved;
    for (auto& [path, file] : files_) {
        if (file.unstored) unstored.push_back(*file.unstored);
        if (std::exchange(file.is_unremoved, false)) unremoved.push_back(path);
    }
    for (MediaRecord& record : unstored)
        write_record(std::move(record));
    for (const std::string& path : unremoved)
        remove_record(path);
    const auto [records, removals] = backlog();
    if (records + removals == 0 && std::exchange(is_lack_told_, false))
        log::info("all records are stored again");
}

FileBook::Backlog FileBook::backlog() const {
    Backlog backlog;
    for (const auto& [path, file] : files_) {
        backlog.records += file.unstored ? 1 : 0;
        backlog.removals += file.is_unremoved ? 1 : 0;
    }
    return backlog;
}

void FileBook::begin_analysis(const std::string& path, const FileFacts& facts) {
    const MediaRecord begun = record_of(path, facts, MediaState::waiting, "");
    states_.note_analysis(path);
    std::unique_ptr<FilmGrowth>& growth = files_[path].growth;
    if (!growth)
        growth = std::make_unique<FilmGrowth>(known_growth(record(path)).value_or(FilmGrowth(begun)));
    growth->begin_analysis(begun);
    store_.begin_writing(store_id(path, facts.bytes, facts.mtime_ns));
}

void FileBook::end_analysis(const std::string& path, const FileFacts& facts) {
    store_.end_writing(store_id(path, facts.bytes, facts.mtime_ns));
    followers_.weaver.note_analysis(path);
    publish_growth();
}

void FileBook::add_growth(const MediaRecord& part) {
    const auto known = files_.find(part.path);
    if (known == files_.end() || !known->second.growth) return;  // the file went, and is forgotten
    known->second.growth->add_shots(part);
    if (!is_growth_resting_) publish_growth();
}

void FileBook::publish_growth() {
    bool has_published = false;
    for (auto& [path, file] : files_) {
        std::optional<MediaRecord> news = file.growth ? file.growth->take_news() : std::nullopt;
        if (!news) continue;
        has_published = true;
        if (schedule_.mark_grown(path)) write_record(std::move(*news));
    }
    if (!has_published) return;
    is_growth_resting_ = true;
    growth_.arm(growth_rest);
}

bool FileBook::request_sounds(const std::vector<std::string>& paths,
                              const std::function<bool(const std::string& path)>& is_heard) {
    if (!store_.is_on()) return false;
    bool has_requested = false;
    for (const std::string& path : paths) {
        const auto known = files_.find(path);
        if (!is_heard(path)) {
            if (known != files_.end()) known->second.is_sound_checked = false;
            continue;
        }
        if (known != files_.end() && known->second.is_sound_checked) continue;
        const std::optional<MediaRecord> heard = record(path);
        if (!heard || heard->state != MediaState::ready || !heard->is_complete) continue;
        File& file = files_[path];
        file.is_sound_checked = true;
        if (!store_.lacks_sound(*heard)) continue;
        schedule_.analyse_again(path);
        has_requested = true;
    }
    return has_requested;
}

bool FileBook::is_news(const MediaRecord& record) {
    if (record.state == MediaState::waiting) return !std::exchange(files_[record.path].is_waiting_told, true);
    if (const auto known = files_.find(record.path); known != files_.end())
        known->second.is_waiting_told = false;
    return true;
}

void FileBook::make_room() {
    const std::set<std::string> paths = store_.make_room();
    for (const std::string& path : paths)
        if (std::optional<MediaRecord> full = record(path)) write_record(std::move(*full));
    if (!paths.empty()) log::info("the store is full: stored shots of {} files are removed", paths.size());
}

void FileBook::sweep(const std::vector<std::string>& paths) {
    store_.sweep();
    followers_.weaver.sweep_tapestries(paths);
}

}  // namespace vitrine::analyzer
