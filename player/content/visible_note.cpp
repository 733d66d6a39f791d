#include "player/content/visible_note.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <system_error>
#include <utility>

namespace vitrine::player {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto min_interval = 1s;

bool write_list(const std::vector<FileVisibility>& files, const fs::path& file) {
    try {
        replace_file_unsynced(file, visible_json(files));
        return true;
    } catch (
        const std::exception& error) {  // no exception may leave a thread; the wall goes on without the file
        log::debug("'{}' is not written: {}", file.string(), error.what());
        return false;
    }
}

}  // namespace

void VisibleNote::write_if_due(Time now, const List& list) {
    if (file_.empty() || (looked_ && now - *looked_ < min_interval)) return;
    looked_ = now;
    if (written_.valid()) {
        if (written_.wait_for(0s) != std::future_status::ready) return;
        if (!written_.get()) return retry_later(now);
    }
    if (std::exchange(has_changed_, false)) {
        std::vector<FileVisibility> files = list();
        if (!told_ || files != files_) {
            told_ = now;
            return write(std::move(files));
        }
    }
    if (now - *told_ < visible_heartbeat) return;
    told_ = now;
    set_time();
}

void VisibleNote::write(std::vector<FileVisibility> files) {
    files_ = files;
    written_ = std::async(std::launch::async, write_list, std::move(files), file_);
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
