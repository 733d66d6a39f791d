#include "analyzer/watch/folder_follower.hpp"

#include "base/hints/hint_file.hpp"
#include "base/hints/keyframe_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

std::string why_offline(const MediaFolder& folder, bool is_suspiciously_empty) {
    if (is_suspiciously_empty) return "is empty; its share may not be mounted";
    const int error = folder.root_error();
    return error == 0 || error == ENOENT ? "is not there"
                                         : fmt::format("cannot be reached: {}", std::strerror(error));
}

/// True where another file system stands in the place of the one that held the files: what is missing in it
/// says nothing about them before the next rescan.
/// @param device  where files were last seen
bool is_elsewhere(const MediaFolder& folder, const std::optional<std::uint64_t>& device) {
    return device && folder.device() != device;
}

std::string relative_to(const fs::path& root, const fs::path& directory) {
    const std::string path = directory.lexically_relative(root).string();
    return path == "." ? "" : path;
}

}  // namespace

void FolderFollower::rescan(Schedule::Time now, const MediaFolder::Attend& attend) {
    is_remote_ = folder_.is_remote();
    unwatched_ = 0;
    const MediaFolder::Listing listing = folder_.list(
        "", [this](const std::string& folder) { watch_folder(folder); }, attend);
    // An empty folder on another file system than before is the place where a share was mounted.
    const bool is_unmounted = listing.files.empty() && is_elsewhere(folder_, device_);
    is_online_ = folder_.device().has_value() && !is_unmounted && !is_suspiciously_empty(listing);
    if (!is_online_) {
        watch_.remove(folder_.root());
        remarks_ = {fmt::format("the media folder '{}' {}", folder_.root().string(),
                                why_offline(folder_, is_suspiciously_empty(listing)))};
        return;
    }
    if (!listing.files.empty() || !device_) device_ = folder_.device();
    has_seen_files_ |= !listing.files.empty();
    std::erase_if(sidecars_, [&](const std::string& file) { return !listing.is_unread(file); });
    compare(listing, "", now);
    remarks_ = listing.remarks;
    inbox_ = listing.inbox;
    std::ranges::sort(inbox_);
    if (unwatched_ > 0)
        remarks_.push_back(fmt::format("{} folders are not watched, only read now and then: {}", unwatched_,
                                       unwatched_because_ == ENOSPC ? "fs.inotify.max_user_watches is too low"
                                                                    : std::strerror(unwatched_because_)));
}

/// The rule of the empty folder: where a catalogue has files, a folder in which this run has seen none says
/// nothing about them. One file in it is proof enough that it is the right one.
bool FolderFollower::is_suspiciously_empty(const MediaFolder::Listing& listing) const {
    return listing.files.empty() && !has_seen_files_ && !schedule_.paths_below("").empty();
}

void FolderFollower::watch_folder(const std::string& folder) {
    const bool is_root = folder.empty();
    if (watch_.add(is_root ? folder_.root() : folder_.absolute(folder), is_root)) return;
    if (errno == ENOENT || errno == ENOTDIR) return;
    ++unwatched_;
    unwatched_because_ = errno;
}

bool FolderFollower::note_failure(const std::string& failure) {
    if (std::ranges::find(remarks_, failure) != remarks_.end()) return false;
    remarks_.push_back(failure);
    return true;
}

FolderFollower::Changes FolderFollower::read_changes() {
    using Kind = DirectoryEvent::Kind;
    Changes changes;
    for (const DirectoryEvent& event : watch_.read()) {
        const std::string path = relative_to(folder_.root(), event.directory / event.name);
        has_hint_news_ |= event.name == hint_file_name || is_sidecar(event.name);
        if (is_sidecar(event.name)) sidecars_.insert(path);
        switch (event.kind) {
        case Kind::written:
            changes.closed.insert(path);
            changes.files.insert(path);
            break;
        case Kind::changed:
        case Kind::removed:
            changes.files.insert(path);
            break;
        case Kind::directory_added:
            changes.added.insert(path);
            break;
        case Kind::directory_removed:
            changes.removed.insert(path);
            break;
        case Kind::self_gone:
            changes.is_lost |= event.directory == folder_.root();
            break;
        case Kind::overflow:
            changes.is_lost = true;
            break;
        }
    }
    return changes;
}

bool FolderFollower::read_events(Schedule::Time now) {
    Changes changes = read_changes();
    has_hint_news_ |= !changes.added.empty() || !changes.removed.empty();
    for (const std::string& folder : changes.removed) {
        watch_.remove(folder_.absolute(folder));
        const std::vector<std::string> lost = schedule_.paths_below(folder);
        changes.files.insert(lost.begin(), lost.end());
        if (std::error_code unknown; folder_.device() && fs::exists(folder_.absolute(folder), unknown))
            changes.added.insert(folder);  // another took its place
    }
    look_at_changed(changes, now);
    for (const std::string& folder : changes.added)
        list_below(folder, now);
    return changes.is_lost;
}

void FolderFollower::look_at(std::span<const std::string> paths, Schedule::Time now) {
    look_at_changed({.files = {paths.begin(), paths.end()}}, now);
}

/// Lost files come first: they may be there again under another name.
void FolderFollower::look_at_changed(const Changes& changes, Schedule::Time now) {
    std::vector<MediaFolder::File> there;
    for (const std::string& path : changes.files) {
        MediaFolder::LookResult look = folder_.look_at(path);
        if (look.presence == MediaFolder::Presence::gone && !is_elsewhere(folder_, device_))
            schedule_.lose_file(path, now);
        if (look.presence == MediaFolder::Presence::there) there.push_back(std::move(look.file));
    }
    for (const MediaFolder::File& file : there)
        see_file(file, now, changes.closed.contains(file.path));
}

void FolderFollower::list_below(const std::string& folder, Schedule::Time now) {
    compare(folder_.list(folder, [this](const std::string& below) { watch_folder(below); }), folder, now);
}

void FolderFollower::compare(const MediaFolder::Listing& listing, const std::string& folder,
                             Schedule::Time now) {
    sidecars_.insert(listing.sidecars.begin(), listing.sidecars.end());
    std::set<std::string> there;
    for (const MediaFolder::File& file : listing.files)
        there.insert(file.path);
    std::vector<std::string> missing;
    for (const std::string& path : schedule_.paths_below(folder))
        if (!there.contains(path) && !listing.is_unread(path)) missing.push_back(path);
    lose_missing(missing, now);
    for (const MediaFolder::File& file : listing.files)
        see_file(file, now);
}

/// A listing is no proof: a share may give half of it, or an old one. A file is lost when it cannot be found
/// by its name either, in the same file system as before.
void FolderFollower::lose_missing(const std::vector<std::string>& missing, Schedule::Time now) {
    std::vector<std::string> lost;
    for (const std::string& path : missing) {
        MediaFolder::LookResult look = folder_.look_at(path);
        if (look.presence == MediaFolder::Presence::gone) lost.push_back(path);
        if (look.presence == MediaFolder::Presence::there) see_file(look.file, now);
    }
    if (is_elsewhere(folder_, device_)) return;
    for (const std::string& path : lost)
        schedule_.lose_file(path, now);
}

/// On a share, a close that this kernel saw does not tell whether another machine still writes the file.
void FolderFollower::see_file(const MediaFolder::File& file, Schedule::Time now, bool is_closed) {
    const LookKind local = is_closed ? LookKind::closed : LookKind::local;
    schedule_.see_file(file.path, file.facts, now, is_remote_ ? LookKind::remote : local);
}

}  // namespace vitrine::analyzer
