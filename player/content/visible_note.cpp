#include "player/content/visible_note.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <algorithm>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto min_interval = 1s;
constexpr auto rest_a_file = 100us;  // between two writings, for each file: some twenty times what one takes

bool is_same(const VisibleState& a, const VisibleState& b) {
    bool is_same = a.on_wall == b.on_wall;
    a.files.for_each_change(b.files,
                            [&](const JudgedFiles::List::Entry& one, const JudgedFiles::List::Entry& other) {
                                is_same = is_same && one && other && *one == *other;
                            });
    return is_same;
}

std::string text_of(const VisibleState& state) {
    std::vector<FileVisibility> files;
    files.reserve(state.files.size());
    const Moments moments(state.records);
    for (const JudgedFiles::List::Entry& file : state.files) {
        files.push_back(has_passed_filters(file->visibility)
                            ? seen_on(*file, state.on_wall, state.groups, moments)
                            : *file);
    }
    return visible_json(files);
}

bool write_state(const VisibleState& state, const fs::path& file) {
    try {
        replace_file_unsynced(file, text_of(state));
        return true;
    } catch (
        const std::exception& error) {  // no exception may leave a thread; the wall goes on without the file
        log::debug("'{}' is not written: {}", file.string(), error.what());
        return false;
    }
}

}  // namespace

FileVisibility seen_on(FileVisibility file, const std::set<std::string>& on_wall, const GroupList& groups,
                       const Moments& moments) {
    if (on_wall.contains(file.path)) file.visibility = Visibility::on_wall;
    if (may_be_shown(file.visibility)) file.detail = moments.words_for(file.path);
    if (file.visibility != Visibility::waits_for_turn) return file;
    const GroupList::Entry entry = groups.find(file.path);
    if (!entry) return file;
    const auto hangs = std::ranges::find_if(
        entry->group->photos, [&](const std::string& photo) { return on_wall.contains(photo); });
    if (hangs == entry->group->photos.end()) return file;
    file.visibility = Visibility::in_group;
    file.detail = *hangs;
    return file;
}

void VisibleNote::write_if_due(Time now, const Look& look) {
    if (file_.empty() || (looked_ && now - *looked_ < min_interval)) return;
    looked_ = now;
    if (written_.valid()) {
        if (written_.wait_for(0s) != std::future_status::ready) return;
        if (!written_.get()) return retry_later(now);
    }
    if (has_changed_ && (!told_ || now >= next_writing_)) {
        has_changed_ = false;
        VisibleState state = look();
        if (!told_ || !is_same(state, state_)) {
            told_ = now;
            next_writing_ =
                now + std::min<Time::duration>(rest_a_file * static_cast<std::int64_t>(state.files.size()),
                                               visible_heartbeat);
            return write(std::move(state));
        }
    }
    if (now - *told_ < visible_heartbeat) return;
    told_ = now;
    set_time();
}

void VisibleNote::write(VisibleState state) {
    state_ = state;
    written_ = std::async(std::launch::async, write_state, std::move(state), file_);
}

/// Sets the file's time. If somebody has deleted the file, it is written again.
void VisibleNote::set_time() {
    std::error_code missing;
    fs::last_write_time(file_, fs::file_time_type::clock::now(), missing);
    if (!missing) return;
    told_.reset();
    has_changed_ = true;
}

void VisibleNote::retry_later(Time now) {
    if (!std::exchange(has_complained_, true))
        log::warning("'{}' cannot be written: the status page does not know what the player shows",
                     file_.string());
    looked_ = now + visible_heartbeat;
    told_.reset();
    has_changed_ = true;
}

void VisibleNote::remove() {
    if (written_.valid()) written_.wait();
    std::error_code missing;
    if (!file_.empty()) fs::remove(file_, missing);
}

}  // namespace vitrine::player
