#include "analyzer/watch/folder_follower.hpp"

#include "base/hints/hint_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

std::vector<std::string> FolderFollower::rescan(Schedule::Time now, const MediaFolder::Attend& attend) {
    is_remote_ = folder_.is_remote();
    unwatched_ = 0;
    MediaFolder::Listing listing = folder_.list(
        "", [this](const std::string& folder) { watch(folder); }, attend);
    is_online_ = folder_.device().has_value() && !is_unmounted(listing);
    if (!is_online_) {
        watch_.remove(folder_.root());
        const char* what =
            is_suspiciously_empty(listing) ? "is empty; its share may not be mounted" : "is not there";
        return {fmt::format("the media folder '{}' {}", folder_.root().string(), what)};
    }
    if (!listing.files.empty() || !device_) device_ = folder_.device();
    has_seen_files_ |= !listing.files.empty();
    compare(listing, "", now);
    if (unwatched_ > 0)
        listing.remarks.push_back(fmt::format(
            "{} folders are only looked at now and then (see fs.inotify.max_user_watches)", unwatched_));
    return listing.remarks;
}

/// An empty folder on another file system than before is the place where a share was mounted.
bool FolderFollower::is_unmounted(const MediaFolder::Listing& listing) const {
    return is_suspiciously_empty(listing) ||
           (listing.files.empty() && device_ && device_ != folder_.device());
}

/// The rule of the empty folder: where a catalogue has files, a folder in which this run has seen none says
/// nothing about them. One file in it is proof enough that it is the right one.
bool FolderFollower::is_suspiciously_empty(const MediaFolder::Listing& listing) const {
    return listing.files.empty() && !has_seen_files_ && !schedule_.paths_below("").empty();
}

void FolderFollower::watch(const std::string& folder) {
    const fs::path path = folder.empty() ? folder_.root() : folder_.absolute(folder);
    if (!watch_.add(path) && fs::exists(path)) ++unwatched_;
}

bool FolderFollower::read_events(Schedule::Time now) {
    using Kind = DirectoryEvent::Kind;
    std::set<std::string> files, closed, added, removed;
    bool is_lost = false;
    for (const DirectoryEvent& event : watch_.read()) {
        const std::string path = relative(event.directory / event.name);
        has_hint_news_ |= event.name == hint_file_name;
        switch (event.kind) {
        case Kind::written:
            closed.insert(path);
            files.insert(path);
            break;
        case Kind::changed:
        case Kind::removed:
            files.insert(path);
            break;
        case Kind::directory_added:
            added.insert(path);
            break;
        case Kind::directory_removed:
            removed.insert(path);
            break;
        case Kind::self_gone:
            is_lost |= event.directory == folder_.root();
            break;
        case Kind::overflow:
            is_lost = true;
            break;
        }
    }
    has_hint_news_ |= !added.empty() || !removed.empty();
    for (const std::string& folder : removed) {
        watch_.remove(folder_.absolute(folder));
        const std::vector<std::string> lost = schedule_.paths_below(folder);
        files.insert(lost.begin(), lost.end());
        if (folder_.device() && fs::exists(folder_.absolute(folder)))
            added.insert(folder);  // another took its place
    }
    look_at(std::vector<std::string>(files.begin(), files.end()), closed, now);
    for (const std::string& folder : added)
        list_below(folder, now);
    return is_lost;
}

void FolderFollower::look_at(std::span<const std::string> paths, Schedule::Time now) {
    look_at(paths, {}, now);
}

/// What is gone is told first: it may be there again under another name.
/// @param closed  files that nobody writes any more, as far as this kernel knows
void FolderFollower::look_at(std::span<const std::string> paths, const std::set<std::string>& closed,
                             Schedule::Time now) {
    std::vector<MediaFolder::File> there;
    for (const std::string& path : paths) {
        MediaFolder::Look look = folder_.look(path);
        if (look.presence == MediaFolder::Presence::gone) schedule_.lose_file(path, now);
        if (look.presence == MediaFolder::Presence::there) there.push_back(std::move(look.file));
    }
    for (const MediaFolder::File& file : there)
        saw(file, now, closed.contains(file.path));
}

void FolderFollower::list_below(const std::string& folder, Schedule::Time now) {
    compare(folder_.list(folder, [this](const std::string& below) { watch(below); }), folder, now);
}

void FolderFollower::compare(const MediaFolder::Listing& listing, const std::string& folder,
                             Schedule::Time now) {
    std::set<std::string> there;
    for (const MediaFolder::File& file : listing.files)
        there.insert(file.path);
    if (listing.is_complete)
        for (const std::string& path : schedule_.paths_below(folder))
            if (!there.contains(path)) schedule_.lose_file(path, now);
    for (const MediaFolder::File& file : listing.files)
        saw(file, now);
}

/// A close that this kernel saw of a file on a share says nothing of those who write it elsewhere.
void FolderFollower::saw(const MediaFolder::File& file, Schedule::Time now, bool is_closed) {
    const LookKind local = is_closed ? LookKind::closed : LookKind::local;
    schedule_.see_file(file.path, file.facts, now, is_remote_ ? LookKind::remote : local);
}

std::string FolderFollower::relative(const fs::path& directory) const {
    const std::string path = directory.lexically_relative(folder_.root()).string();
    return path == "." ? "" : path;
}

}  // namespace vitrine::analyzer
