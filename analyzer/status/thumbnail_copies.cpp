#include "analyzer/status/thumbnail_copies.hpp"

#include "base/system/atomic_file.hpp"

#include <chrono>
#include <optional>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr auto max_unused_age = std::chrono::minutes(10);  // for a thumbnail that no file on the page has
constexpr std::size_t max_picture_bytes = 4U << 20;
constexpr std::string_view ending = ".jpg";

std::string file_name(const StatusEntry& entry) {
    return entry.id + std::string(ending);
}

}  // namespace

std::optional<std::string> read_picture(const fs::path& file) {
    std::error_code missing;
    if (!fs::exists(file, missing)) return std::nullopt;
    try {
        return read_file(file, max_picture_bytes);
    } catch (const std::system_error&) {  // it went just now: as good as none
        return std::nullopt;
    }
}

void ThumbnailCopies::update(const StatusFolder& folder, const std::vector<StatusEntry>& page) {
    std::set<std::string> wanted;
    lacking_.clear();
    for (const StatusEntry& entry : page) {
        if (entry.file.state != FileState::State::ready) continue;
        wanted.insert(file_name(entry));
        std::error_code missing;
        if (!fs::exists(thumbnails_ / file_name(entry), missing)) lacking_.push_back(entry.file.path);
    }
    copy_changed(folder, wanted);
    read_folder(folder);
    remove_old(wanted);
}

void ThumbnailCopies::copy_changed(const StatusFolder& folder, const std::set<std::string>& wanted) {
    for (const std::string& name : wanted) {
        std::error_code missing;
        const auto time = fs::last_write_time(thumbnails_ / name, missing);
        if (missing || (copied_.contains(name) && copied_.at(name) == time)) continue;
        const auto jpeg = read_picture(thumbnails_ / name);
        if (!jpeg) continue;
        folder.write("thumbnails", name, *jpeg);
        copied_[name] = time;
    }
    std::erase_if(copied_, [&](const auto& copied) { return !wanted.contains(copied.first); });
}

/// Removes foreign files from the folder; a copy that somebody has deleted is made again the next time.
void ThumbnailCopies::read_folder(const StatusFolder& folder) {
    ids_.clear();
    const std::set<std::string> there = folder.names("thumbnails", ending);
    for (const std::string& name : there) {
        if (copied_.contains(name))
            ids_.insert(name.substr(0, name.size() - ending.size()));
        else
            folder.remove("thumbnails", name);
    }
    std::erase_if(copied_, [&](const auto& copied) { return !there.contains(copied.first); });
}

/// A thumbnail that a child has just made may belong to a file that becomes ready in a moment: only old ones
/// go.
void ThumbnailCopies::remove_old(const std::set<std::string>& wanted) const {
    std::error_code error;
    const auto oldest = fs::file_time_type::clock::now() - max_unused_age;
    for (const fs::directory_entry& entry : fs::directory_iterator(thumbnails_, error)) {
        std::error_code gone;
        if (!wanted.contains(entry.path().filename().string()) && entry.last_write_time(gone) < oldest &&
            !gone)
            fs::remove(entry.path(), gone);
    }
}

}  // namespace vitrine::analyzer
