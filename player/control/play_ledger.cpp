#include "player/control/play_ledger.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/error.hpp"
#include "base/system/log.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto note_period = 1s;
constexpr auto day_period = 60s;

/// Holds the files that one run of the writing thread writes.
struct Writing {
    fs::path folder;
    std::string day;
    std::optional<PlayedTimes> times;  // the whole day; none: it is not due
    std::string now;                   // the times that the day's file does not have
};

/// Overwrites a file in place, without fsync: that costs the disk least. A line that is torn fails its
/// checksum; a line of before that is left behind has a shorter time, which does not count.
void overwrite(const fs::path& file, std::string_view text) {
    const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644));
    if (!fd.is_open()) throw_errno("open '{}'", file.string());
    if (::pwrite(fd.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()) ||
        ::ftruncate(fd.get(), static_cast<off_t>(text.size())) < 0)
        throw_errno("write '{}'", file.string());
}

bool carry_out(const Writing& writing) {
    try {
        if (writing.times)
            replace_file(writing.folder / writing.day, played_text(writing.day, *writing.times));
        overwrite(writing.folder / played_now, writing.now);
        return true;
    } catch (const std::exception& error) {  // no exception may leave a thread; the wall goes on
        log::debug("the times of files are not written: {}", error.what());
        return false;
    }
}

PlayedTimes read_day(const fs::path& folder, const std::string& name) {
    PlayedTimes times;
    std::error_code missing;
    if (fs::exists(folder / name, missing)) merge_played(read_file(folder / name), name, times);
    return times;
}

/// The names of the days in a text of played_text().
std::set<std::string> days_in(const std::string& text) {
    std::set<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const std::string name = line.substr(0, line.find(' ')); is_played_day(name)) names.insert(name);
    return names;
}

}  // namespace

PlayLedger::PlayLedger(fs::path folder) : folder_(std::move(folder)) {
    try {
        fs::create_directories(folder_);
        recover();
        remove_old();
    } catch (const std::system_error& error) {
        log::warning("proof of play: {}", error.what());
    }
}

PlayLedger::~PlayLedger() {
    if (day_.name.empty()) return;
    finish_writing();
    write(true);
}

void PlayLedger::recover() {
    const fs::path now = folder_ / played_now;
    if (!fs::exists(now)) return;
    const std::string text = read_file(now);
    for (const std::string& name : days_in(text)) {
        PlayedTimes times = read_day(folder_, name);
        const PlayedTimes before = times;
        merge_played(text, name, times);
        if (times != before) replace_file(folder_ / name, played_text(name, times));
    }
    fs::remove(now);
}

void PlayLedger::remove_old() const {
    std::vector<std::string> days;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        if (const std::string name = entry.path().filename(); is_played_day(name)) days.push_back(name);
    std::ranges::sort(days, std::greater());
    for (std::size_t i = max_played_days; i < days.size(); ++i)
        fs::remove(folder_ / days[i]);
}

void PlayLedger::look(std::set<std::string> seen, Duration now, const Day& day) {
    std::string name = played_day_name(day);
    if (name != day_.name) change_day(std::move(name));
    if (last_) count(std::clamp<Duration>(now - *last_, 0s, max_gap));
    last_ = now;
    seen_ = std::move(seen);
    if (now < next_note_ || !is_written()) return;
    next_note_ = now + note_period;
    if (fresh_.empty()) return;
    const bool is_day_due = now >= next_day_;
    if (is_day_due) next_day_ = now + day_period;
    write(is_day_due);
}

void PlayLedger::count(Duration elapsed) {
    for (const std::string& path : seen_) {
        const bool has_room = day_.times.size() < max_played_files || day_.times.contains(path);
        const std::string& counted = has_room ? path : std::string();
        day_.times[counted] += elapsed;
        fresh_.insert(counted);
    }
}

/// The clock may be set forth and back: the day that was just left is still known.
void PlayLedger::change_day(std::string name) {
    if (!day_.name.empty()) {
        finish_writing();
        write(true);
    }
    fresh_.clear();
    handed_.clear();
    std::swap(day_, before_);
    if (day_.name == name) return;
    day_ = {.name = std::move(name), .times = {}};
    try {
        day_.times = read_day(folder_, day_.name);
        remove_old();
    } catch (const std::system_error& error) {
        log::warning("proof of play: {}", error.what());
    }
}

void PlayLedger::finish_writing() {
    if (written_.valid()) end_writing();
}

/// True: the thread writes nothing any more.
bool PlayLedger::is_written() {
    if (!written_.valid()) return true;
    if (written_.wait_for(0s) != std::future_status::ready) return false;
    end_writing();
    return true;
}

/// Waits for the thread. Files that it could not write into the day's file are fresh again.
void PlayLedger::end_writing() {
    if (!written_.get()) {
        fresh_.merge(handed_);
        next_day_ = {};
        if (!std::exchange(has_complained_, true))
            log::warning("proof of play: the times of files cannot be written to '{}'", folder_.string());
    }
    handed_.clear();
}

/// @pre the thread writes nothing
void PlayLedger::write(bool is_day_due) {
    Writing writing{.folder = folder_, .day = day_.name, .times = {}, .now = {}};
    PlayedTimes fresh;
    for (const std::string& path : fresh_)
        fresh[path] = day_.times[path];
    writing.now = played_text(day_.name, fresh);
    if (is_day_due) {
        writing.times = day_.times;
        handed_ = std::exchange(fresh_, {});
    }
    written_ = std::async(std::launch::async, carry_out, std::move(writing));
}

}  // namespace vitrine::player
