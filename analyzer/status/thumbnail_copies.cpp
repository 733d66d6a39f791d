#include "analyzer/status/thumbnail_copies.hpp"

#include "base/system/atomic_file.hpp"

#include <chrono>
#include <exception>
#include <optional>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr auto max_unused_age = std::chrono::minutes(10);  // for a thumbnail that no file on the page has
constexpr std::size_t max_picture_bytes = 4U << 20;
constexpr std::string_view ending = ".jpg";

std::string name_of_copy(const std::string& id) {
    return id + std::string(ending);
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
        wanted.insert(entry.id);
        std::error_code missing;
        if (!fs::exists(thumbnail_place(thumbnails_, entry.id), missing)) lacking_.push_back(entry.file.path);
    }
    std::exception_ptr failure;
    for (const std::string& id : wanted) {
        try {
            copy_if_changed(folder, id);
        } catch (const std::system_error&) {  // somebody's folder of that name is in the way
            if (!failure) failure = std::current_exception();
        }
    }
    std::erase_if(copied_, [&](const auto& copied) { return !wanted.contains(copied.first); });
    read_folder(folder);
    remove_old(wanted);
    if (failure) std::rethrow_exception(failure);
}

void ThumbnailCopies::copy_if_changed(const StatusFolder& folder, const std::string& id) {
    const fs::path made = thumbnail_place(thumbnails_, id);
    std::error_code missing;
    const auto time = fs::last_write_time(made, missing);
    if (missing || (copied_.contains(id) && copied_.at(id) == time)) return;
    const auto jpeg = read_picture(made);
    if (!jpeg) return;
    folder.write("thumbnails", name_of_copy(id), *jpeg);
    copied_[id] = time;
}

/// Removes foreign files from the folder; a copy that somebody has deleted is made again the next time.
void ThumbnailCopies::read_folder(const StatusFolder& folder) {
    ids_.clear();
    const std::set<std::string> there = folder.names("thumbnails", ending);
    for (const std::string& name : there) {
        const std::string id = name.substr(0, name.size() - ending.size());
        if (copied_.contains(id))
            ids_.insert(id);
        else
            folder.remove("thumbnails", name);
    }
    std::erase_if(copied_, [&](const auto& copied) { return !ids_.contains(copied.first); });
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
            fs::remove_all(entry.path(), gone);
    }
}

}  // namespace vitrine::analyzer
