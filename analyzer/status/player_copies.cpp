#include "analyzer/status/player_copies.hpp"

#include "analyzer/status/plain_text.hpp"
#include "analyzer/status/thumbnail_copies.hpp"
#include "base/state/name_hash.hpp"
#include "base/state/played_times.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <system_error>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view table_ending = ".csv";

std::string text_of(const fs::path& file) {
    std::error_code missing;
    return fs::exists(file, missing) ? read_file(file) : std::string();
}

/// The days of the player, the latest first.
std::vector<std::string> days_in(const fs::path& folder) {
    std::vector<std::string> days;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
        if (std::string name = entry.path().filename(); is_played_day(name)) days.push_back(std::move(name));
    std::ranges::sort(days, std::greater());
    return days;
}

std::string in_quotes(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

}  // namespace

std::string played_csv(std::string_view day, std::string_view texts) {
    PlayedTimes times;
    merge_played(texts, day, times);
    std::string csv = "file,seconds\r\n";
    for (const auto& [path, time] : times)
        csv += fmt::format("{},{:.1f}\r\n", in_quotes(path.empty() ? "all others" : "/" + plain_text(path)),
                           std::chrono::duration<double>(time).count());
    return csv;
}

void PlayerCopies::copy_wall(const StatusFolder& folder) {
    const auto jpeg = read_picture(state_ / "wall.jpg");
    if (!jpeg) return;
    folder.write("", "wall.jpg", *jpeg);
    has_wall_ = true;
}

void PlayerCopies::copy_played(const StatusFolder& folder) {
    const fs::path played = state_ / played_folder;
    const std::vector<std::string> days = days_in(played);
    if (days.empty()) return;
    if (copied_.empty()) folder.remove_unfinished(played_folder);
    const std::string now = text_of(played / played_now);
    for (const std::string& day : days) {
        if (copied_.contains(day) && day != days.front() && now.find(day) == std::string::npos) continue;
        const std::string texts = text_of(played / day) + now;
        std::string hash = name_hash(texts);
        if (copied_[day] == hash) continue;
        folder.write(played_folder, day + std::string(table_ending), played_csv(day, texts));
        copied_[day] = std::move(hash);
        has_played_ = true;
    }
    std::vector<std::string> tables;
    for (const std::string& name : folder.names(played_folder, table_ending))
        if (is_played_day(name.substr(0, name.size() - table_ending.size()))) tables.push_back(name);
    std::ranges::sort(tables, std::greater());
    for (std::size_t i = max_played_days; i < tables.size(); ++i)
        folder.remove(played_folder, tables[i]);
}

}  // namespace vitrine::analyzer
