#include "analyzer/status/status_writer.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/local_time.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto first_rest = 500ms;   // many changes together are one
constexpr auto least_rest = 2s;      // between two writings
constexpr auto rest_a_file = 1ms;    // more
constexpr auto wall_interval = 15s;  // between two looks at the files of the player
constexpr auto surplus_age = 10min;  // of a thumbnail that no file on the page has
constexpr std::size_t largest_picture = 4U << 20;

std::string clock_text(std::chrono::system_clock::time_point time) {
    const auto local = local_time(time);
    const auto day = std::chrono::floor<std::chrono::days>(local);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss clock(local - day);
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       clock.hours().count(), clock.minutes().count());
}

/// Nothing where there is none, or too large a one.
std::optional<std::string> picture(const fs::path& file) {
    std::error_code missing;
    if (!fs::exists(file, missing)) return std::nullopt;
    try {
        return read_file(file, largest_picture);
    } catch (const std::system_error&) {  // it went just now: as good as none
        return std::nullopt;
    }
}

}  // namespace

StatusWriter::StatusWriter(EventLoop& loop, fs::path root, const std::string& folder, fs::path state, Ask ask)
    : state_(std::move(state)),
      player_(state_),
      ask_(std::move(ask)),
      rest_(least_rest),
      due_(loop.timer([this] { write(); })),
      wall_(loop.timer([this] {
          copy_wall();
          look_at_player();
          wall_.arm(wall_interval);
      })) {
    if (folder.empty()) return;
    folder_.emplace(std::move(root), folder);
    wall_.arm(wall_interval);
}

void StatusWriter::touch() {
    if (is_due_) return;
    is_due_ = true;
    const auto now = EventLoop::Clock::now();
    const auto earliest = written_ ? *written_ + rest_ : now;
    due_.arm(std::max<EventLoop::Clock::duration>(first_rest, earliest - now));
}

void StatusWriter::write() {
    is_due_ = false;
    due_.disarm();
    StatusReport report = ask_();
    add_player(report);
    rest_ = least_rest + rest_a_file * static_cast<std::int64_t>(report.files.size());
    try {
        std::string json = status_json(report);
        if (json != told_) replace_file(state_ / "status.json", json);
        told_ = std::move(json);
    } catch (const std::system_error& error) {  // a full disk: tried again with the next change
        log::error("the status is not stored: {}", error.what());
    }
    is_online_ = report.is_online;
    if (folder_ && is_online_) write_folder(report);
    written_ = EventLoop::Clock::now();
}

void StatusWriter::write_folder(const StatusReport& report) {
    try {
        const std::vector<StatusEntry> files = on_page(report);
        copy_thumbnails(files);
        copy_wall();
        folder_->write("", "index.html", status_page(report, files, thumbnails_, has_wall_, clock_text));
        folder_->write("", "status.txt", status_text(report, clock_text));
        if (!complaint_.empty()) log::info("the status folder is written again");
        complaint_.clear();
    } catch (const std::system_error& error) {
        complain(error);
    }
}

/// Those on the page; what is not on it any more has no thumbnail, here and in STATE.
void StatusWriter::copy_thumbnails(const std::vector<StatusEntry>& files) {
    const std::string ending = ".jpg";
    const fs::path from = state_ / "thumbnails";
    std::set<std::string> wanted;
    lacking_.clear();
    for (const StatusEntry& entry : files) {
        if (entry.file.state != FileState::State::ready) continue;
        wanted.insert(entry.id + ending);
        std::error_code missing;
        if (!fs::exists(from / (entry.id + ending), missing)) lacking_.push_back(entry.file.path);
    }
    for (const std::string& name : wanted) {
        std::error_code missing;
        const auto time = fs::last_write_time(from / name, missing);
        if (missing || (copied_.contains(name) && copied_.at(name) == time)) continue;
        const auto jpeg = picture(from / name);
        if (!jpeg) continue;
        folder_->write("thumbnails", name, *jpeg);
        copied_[name] = time;
    }
    std::erase_if(copied_, [&](const auto& copied) { return !wanted.contains(copied.first); });
    thumbnails_.clear();
    for (const std::string& name : folder_->names("thumbnails", ending)) {
        if (!copied_.contains(name))
            folder_->remove("thumbnails", name);
        else
            thumbnails_.insert(name.substr(0, name.size() - ending.size()));
    }
    std::erase_if(copied_, [&](const auto& copied) {  // somebody has deleted it: copied again
        return !thumbnails_.contains(copied.first.substr(0, copied.first.size() - ending.size()));
    });
    remove_surplus(wanted);
}

/// What a child has just made may belong to a file that becomes ready in a moment.
void StatusWriter::remove_surplus(const std::set<std::string>& wanted) const {
    std::error_code error;
    const auto old = fs::file_time_type::clock::now() - surplus_age;
    for (const fs::directory_entry& entry : fs::directory_iterator(state_ / "thumbnails", error)) {
        std::error_code gone;
        if (!wanted.contains(entry.path().filename().string()) && entry.last_write_time(gone) < old && !gone)
            fs::remove(entry.path(), gone);
    }
}

void StatusWriter::copy_wall() {
    const auto jpeg = picture(state_ / "wall.jpg");
    if (!jpeg || !folder_ || !is_online_) return;
    try {
        folder_->write("", "wall.jpg", *jpeg);
        if (!has_wall_) touch();
        has_wall_ = true;
    } catch (const std::system_error& error) {
        complain(error);
    }
}

void StatusWriter::look_at_player() {
    if (player_.look(fs::file_time_type::clock::now())) touch();
}

void StatusWriter::add_player(StatusReport& report) {
    (void)player_.look(fs::file_time_type::clock::now());
    report.is_player_running = player_.is_player_running();
    for (StatusEntry& entry : report.files) {
        const auto found = player_.files().find(entry.file.path);
        if (found != player_.files().end()) entry.on_wall = found->second;
    }
}

void StatusWriter::complain(const std::exception& error) {
    if (complaint_ != error.what())
        log::warning("there is no status folder in the media folder: {}", error.what());
    complaint_ = error.what();
}

}  // namespace vitrine::analyzer
