#include "player/wall_link/wanted_files.hpp"

#include "base/system/atomic_file.hpp"

#include <system_error>

namespace vitrine::player {

namespace {

constexpr auto spacing = std::chrono::milliseconds(500);  // of what is told

}  // namespace

bool WantedFiles::is_due(std::chrono::nanoseconds now) const {
    return !told_at_ || now - *told_at_ >= spacing;
}

void WantedFiles::tell(const std::set<std::string>& files, std::chrono::nanoseconds now) {
    told_at_ = now;
    if (told_ == files) return;
    told_ = files;
    std::string lines;
    for (const std::string& file : files)
        lines += file + "\n";
    try {
        replace_file_unsynced(file_, lines);
    } catch (const std::system_error&) {
        told_.reset();
    }
}

}  // namespace vitrine::player
