#include "analyzer/watch/media_folder.hpp"

#include "base/hints/caption.hpp"
#include "base/hints/hint_words.hpp"
#include "base/hints/keyframe_choice.hpp"
#include "base/state/path_text.hpp"
#include "base/system/written_size.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include <dirent.h>

namespace vitrine::analyzer {

namespace {

constexpr std::array junk_names{"thumbs.db",  "ehthumbs.db", "desktop.ini",
                                "@eadir",     "#recycle",    "$recycle.bin",
                                "lost+found", "_status",     "system volume information",
                                "__macosx"};
constexpr std::array junk_endings{"~",    ".part",     ".partial",    ".crdownload",
                                  ".tmp", ".filepart", ".opdownload", ".download"};

/// "..2026-12-24 Advent" is hidden for some programs, but meant to be seen.
bool begins_with_period(std::string_view name) {
    return name.starts_with("..") && hints_in_name(name, NamePart::folder).period.has_value();
}

bool has_junk_part(const std::string& path) {
    const std::filesystem::path parts(path);
    return std::any_of(parts.begin(), parts.end(),
                       [](const auto& part) { return is_junk_name(part.string()); });
}

std::chrono::nanoseconds to_nanoseconds(const timespec& time) {
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// @param parent  folder whose entry `name` has this status
MediaFolder::File to_file(const std::string& path, const struct stat& status, int parent, const char* name) {
    return {.path = path,
            .facts = {.bytes = static_cast<std::uint64_t>(status.st_size),
                      .mtime_ns = to_nanoseconds(status.st_mtim).count(),
                      .blocks = static_cast<std::uint64_t>(status.st_blocks),
                      .inode = status.st_ino,
                      .is_readable = ::faccessat(parent, name, R_OK, AT_EACCESS) == 0}};
}

/// An entry that was listed is not there any more, or is a link.
bool is_absence(int error) {
    return error == ENOENT || error == ENOTDIR || error == ELOOP || error == EXDEV;
}

/// A file whose folders are opened one by one, links as themselves, is not there. No other error proves that.
bool is_gone(int error) {
    return error == ENOENT || error == ENOTDIR || error == EXDEV;
}

/// An entry of a folder, unless it is a link or leads out of it.
UniqueFd open_below(const UniqueFd& folder, const std::string& name, int flags) {
    if (name == "..") {
        errno = EXDEV;
        return {};
    }
    return UniqueFd(::openat(folder.get(), name.c_str(), flags | O_CLOEXEC | O_NOFOLLOW));
}

struct CloseDirectory {
    void operator()(DIR* directory) const { ::closedir(directory); }
};

using Directory = std::unique_ptr<DIR, CloseDirectory>;

/// One reading of a folder and all folders below it.
struct Walk {
    const MediaFolder::Enter& enter;
    const MediaFolder::Attend& attend;
    const std::vector<std::string>& passed_over;
    MediaFolder::Listing listing;
    bool is_full_told = false;

    void remark(const std::string& path, const char* what) {
        listing.unread.push_back(path);
        listing.remarks.push_back(fmt::format("'{}': {}", path, what));
    }

    void read(UniqueFd fd, const std::string& folder, int depth) {
        if (depth > MediaFolder::max_depth) return remark(folder, "too many folders within folders");
        const Directory directory(::fdopendir(fd.get()));
        if (!directory) return remark(folder, std::strerror(errno));
        (void)fd.release();  // closedir closes it
        errno = 0;
        while (const dirent* entry = ::readdir(directory.get())) {
            if (is_sidecar(entry->d_name) && !is_in_inbox(folder))
                note_sidecar(folder, entry->d_name);
            else if (!is_junk_name(entry->d_name))
                visit(::dirfd(directory.get()), folder, entry->d_name, depth);
            errno = 0;
        }
        if (errno != 0) remark(folder, std::strerror(errno));
    }

    void note_sidecar(const std::string& folder, const char* name) {
        if (listing.sidecars.size() < MediaFolder::max_files)
            listing.sidecars.push_back(folder.empty() ? name : folder + "/" + name);
    }

    void visit(int parent, const std::string& folder, const char* name, int depth) {
        const std::string path = folder.empty() ? name : folder + "/" + name;
        if (attend) attend();
        if (std::ranges::find(passed_over, path) != passed_over.end()) return;

        struct stat status {};

        if (::fstatat(parent, name, &status, AT_SYMLINK_NOFOLLOW) < 0) {
            if (!is_absence(errno)) remark(path, std::strerror(errno));
            return;
        }
        if (S_ISDIR(status.st_mode)) return descend(parent, name, path, depth);
        if (!S_ISREG(status.st_mode)) return;
        if (is_in_inbox(path)) {
            if (listing.inbox.size() < MediaFolder::max_inbox) listing.inbox.push_back(path);
            return;
        }
        if (listing.files.size() >= MediaFolder::max_files) {
            if (!std::exchange(is_full_told, true))
                listing.remarks.push_back(fmt::format("'{}': too many files; the rest is ignored", path));
            return;
        }
        listing.files.push_back(to_file(path, status, parent, name));
    }

    void descend(int parent, const char* name, const std::string& path, int depth) {
        if (enter && !is_in_inbox(path)) enter(path);
        UniqueFd fd(::openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (fd.is_open()) return read(std::move(fd), path, depth + 1);
        if (!is_absence(errno)) remark(path, std::strerror(errno));
    }
};

}  // namespace

bool is_sidecar(std::string_view name) {
    return is_keyframe_file(name) || is_caption_file(name) || is_code_file(name);
}

bool is_junk_name(std::string_view name) {
    const std::string lower = lower_case(name);
    return (lower.starts_with('.') && !begins_with_period(name)) || lower.starts_with("~$") ||
           is_sidecar(name) || std::find(junk_names.begin(), junk_names.end(), lower) != junk_names.end() ||
           std::any_of(junk_endings.begin(), junk_endings.end(),
                       [&](const char* ending) { return lower.ends_with(ending); });
}

/// Opens folder by folder, so that no link below the root is followed. openat2() would do that at once, but a
/// service that systemd keeps from making setuid files does not have it.
UniqueFd MediaFolder::open(const std::string& path, int flags) const {
    UniqueFd folder(::open(root_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    std::size_t begin = 0;
    for (std::size_t end; folder.is_open() && (end = path.find('/', begin)) != std::string::npos;
         begin = end + 1)
        folder = open_below(folder, path.substr(begin, end - begin), O_PATH | O_DIRECTORY);
    if (!folder.is_open()) return {};
    return open_below(folder, path.empty() ? "." : path.substr(begin), flags);
}

bool MediaFolder::is_passed_over(const std::string& path) const {
    return std::ranges::any_of(passed_over_, [&](const std::string& folder) {
        return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
    });
}

std::optional<std::string> MediaFolder::content(const std::string& path, std::size_t max_bytes) const {
    const UniqueFd file = open(path, O_RDONLY | O_NONBLOCK);

    struct stat status {};

    if (!file.is_open() || ::fstat(file.get(), &status) < 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    std::string text(std::min(max_bytes, static_cast<std::size_t>(status.st_size)), '\0');
    const ssize_t size = ::pread(file.get(), text.data(), text.size(), 0);
    if (size < 0) return std::nullopt;
    text.resize(static_cast<std::size_t>(size));
    return text;
}

MediaFolder::LookResult MediaFolder::look_at(const std::string& path) const {
    if (has_junk_part(path) || is_passed_over(path) || is_in_inbox(path)) return {};
    if (!device()) return {.presence = Presence::unreachable, .file = {}};
    const UniqueFd file = open(path, O_PATH);
    if (!file.is_open())
        return {.presence = is_gone(errno) ? Presence::gone : Presence::unreachable, .file = {}};

    struct stat status {};

    if (::fstat(file.get(), &status) < 0) return {.presence = Presence::unreachable, .file = {}};
    if (!S_ISREG(status.st_mode)) return {};
    return {.presence = Presence::there, .file = to_file(path, status, AT_FDCWD, absolute(path).c_str())};
}

bool MediaFolder::Listing::is_unread(const std::string& path) const {
    return std::ranges::any_of(unread, [&](const std::string& part) {
        return part.empty() || path == part || (path.starts_with(part) && path[part.size()] == '/');
    });
}

MediaFolder::Listing MediaFolder::list(const std::string& folder, const Enter& enter,
                                       const Attend& attend) const {
    Walk walk{.enter = enter, .attend = attend, .passed_over = passed_over_, .listing = {}};
    if (has_junk_part(folder) || is_passed_over(folder) || is_in_inbox(folder)) return walk.listing;
    if (enter) enter(folder);
    UniqueFd fd = open(folder, O_RDONLY | O_DIRECTORY);
    const int depth =
        static_cast<int>(std::count(folder.begin(), folder.end(), '/')) + (folder.empty() ? 0 : 1);
    if (fd.is_open())
        walk.read(std::move(fd), folder, depth);
    else if (folder.empty() || !is_absence(errno))
        walk.remark(folder, std::strerror(errno));
    return walk.listing;
}

int MediaFolder::root_error() const {
    struct stat status {};

    if (::stat(root_.c_str(), &status) < 0) return errno;
    return S_ISDIR(status.st_mode) ? 0 : ENOTDIR;
}

std::optional<std::uint64_t> MediaFolder::device() const {
    struct stat status {};

    if (::stat(root_.c_str(), &status) < 0 || !S_ISDIR(status.st_mode)) return std::nullopt;
    return status.st_dev;
}

bool MediaFolder::is_remote() const {
    constexpr std::array<std::uint32_t, 8> remote{
        0xFF534D42, 0xFE534D42, 0x517B,     0x6969,       // CIFS, SMB2, SMB, NFS
        0x65735546, 0x01021997, 0x00C36400, 0x5346414F};  // FUSE, 9P, Ceph, AFS

    struct statfs status {};

    if (::statfs(root_.c_str(), &status) < 0) return false;
    return std::find(remote.begin(), remote.end(), static_cast<std::uint32_t>(status.f_type)) != remote.end();
}

bool MediaFolder::ends_in_hole(const std::string& path) const {
    const UniqueFd file = open(path, O_RDONLY | O_NONBLOCK);
    if (!file.is_open()) return false;

    struct stat status {};

    if (::fstat(file.get(), &status) < 0) return false;
    return written_size(file.get()) < static_cast<std::uint64_t>(status.st_size);
}

}  // namespace vitrine::analyzer
