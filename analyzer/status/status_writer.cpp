#include "analyzer/status/status_writer.hpp"

#include "analyzer/status/status_page.hpp"
#include "analyzer/status/status_text.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "base/system/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto first_rest = 500ms;   // several changes within it become one writing
constexpr auto min_rest = 2s;        // between two writings
constexpr auto rest_a_file = 1ms;    // added for each file
constexpr auto wall_interval = 15s;  // between two looks at the player's files

std::string clock_text(std::chrono::system_clock::time_point time) {
    const auto local = local_time(time);
    const auto day = std::chrono::floor<std::chrono::days>(local);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss clock(local - day);
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       clock.hours().count(), clock.minutes().count());
}

}  // namespace

StatusWriter::StatusWriter(EventLoop& loop, fs::path root, const std::string& folder, fs::path state,
                           MakeReport make_report)
    : state_(std::move(state)),
      player_(state_),
      make_report_(std::move(make_report)),
      rest_(min_rest),
      thumbnails_(state_ / "thumbnails"),
      copies_(state_),
      due_(loop.timer([this] { write(); })),
      wall_(loop.timer([this] {
          copy_from_player();
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
    StatusReport report = make_report_();
    add_player(report);
    rest_ = min_rest + rest_a_file * static_cast<std::int64_t>(report.files.size());
    try {
        std::string json = status_json(report);
        if (json != json_) replace_file(state_ / "status.json", json);
        json_ = std::move(json);
    } catch (const std::system_error& error) {  // a full disk: tried again with the next change
        log::error("the status is not stored: {}", error.what());
    }
    is_online_ = report.is_online;
    if (folder_ && is_online_) write_folder(report);
    written_ = EventLoop::Clock::now();
}

/// A name that somebody blocks keeps no other file from being written.
void StatusWriter::write_folder(const StatusReport& report) {
    const std::vector<StatusEntry> files = on_page(report);
    if (!is_clean_)
        write_part([&] {
            folder_->remove_unfinished("");
            folder_->remove_unfinished("thumbnails");
            is_clean_ = true;
        });
    write_part([&] { thumbnails_.update(*folder_, files); });
    copy_from_player();
    write_part([&] {
        folder_->write("", "index.html",
                       status_page(report, files,
                                   {.thumbnails = thumbnails_.ids(),
                                    .has_wall = copies_.has_wall(),
                                    .has_played = copies_.has_played()},
                                   clock_text));
    });
    write_part([&] { folder_->write("", "status.txt", status_text(report, clock_text)); });
    end_complaints();
}

void StatusWriter::copy_from_player() {
    if (!folder_ || !is_online_) return;
    const auto has_all = [this] { return std::pair(copies_.has_wall(), copies_.has_played()); };
    const auto before = has_all();
    write_part([&] { copies_.copy_wall(*folder_); });
    write_part([&] { copies_.copy_played(*folder_); });
    if (has_all() != before) touch();
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

void StatusWriter::write_part(const std::function<void()>& part) {
    try {
        part();
    } catch (const std::system_error& error) {
        const auto [complaint, is_new] = complaints_.try_emplace(error.what());
        complaint->second = true;
        if (is_new)
            log::warning("the status folder in the media folder is missing or not complete: {}",
                         error.what());
    }
}

/// Forgets the complaints whose reason is gone.
void StatusWriter::end_complaints() {
    const std::size_t gone = std::erase_if(complaints_, [](const auto& entry) { return !entry.second; });
    if (gone > 0 && complaints_.empty()) log::info("the status folder is written again");
    for (auto& [what, is_seen] : complaints_)
        is_seen = false;
}

}  // namespace vitrine::analyzer
