#include "base/system/directory_watch.hpp"

#include "base/system/error.hpp"

#include <sys/inotify.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

namespace vitrine {

namespace {

constexpr std::uint32_t wanted = IN_CLOSE_WRITE | IN_MOVED_FROM | IN_MOVED_TO | IN_CREATE | IN_DELETE |
                                 IN_DELETE_SELF | IN_MOVE_SELF | IN_ATTRIB | IN_ONLYDIR | IN_EXCL_UNLINK;

/// The kind of an event. None: the event does not matter, such as a new file that is still being written.
std::optional<DirectoryEvent::Kind> kind_of(std::uint32_t mask) {
    using Kind = DirectoryEvent::Kind;
    if ((mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT)) != 0) return Kind::self_gone;
    const bool is_directory = (mask & IN_ISDIR) != 0;
    if ((mask & (IN_DELETE | IN_MOVED_FROM)) != 0)
        return is_directory ? Kind::directory_removed : Kind::removed;
    if (is_directory) return (mask & IN_IGNORED) == 0 ? std::optional(Kind::directory_added) : std::nullopt;
    if ((mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0) return Kind::written;
    if ((mask & IN_ATTRIB) != 0) return Kind::changed;
    return std::nullopt;
}

bool is_in(const std::filesystem::path& path, const std::filesystem::path& directory) {
    return std::mismatch(directory.begin(), directory.end(), path.begin(), path.end()).first ==
           directory.end();
}

}  // namespace

DirectoryWatch::DirectoryWatch() : inotify_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (!inotify_.is_open()) throw_errno("watch directories (inotify)");
}

bool DirectoryWatch::add(const std::filesystem::path& directory, bool follows_link) {
    const std::uint32_t events = follows_link ? wanted : wanted | IN_DONT_FOLLOW;
    const int id = ::inotify_add_watch(inotify_.get(), directory.c_str(), events);
    if (id < 0) return false;
    const auto known = by_path_.find(directory);
    if (known != by_path_.end() && known->second != id) by_id_.erase(known->second);
    const auto before = by_id_.find(id);
    if (before != by_id_.end() && before->second != directory) by_path_.erase(before->second);
    by_id_[id] = directory;
    by_path_[directory] = id;
    return true;
}

void DirectoryWatch::remove(const std::filesystem::path& directory) {
    for (auto it = by_path_.lower_bound(directory); it != by_path_.end() && is_in(it->first, directory);) {
        ::inotify_rm_watch(inotify_.get(), it->second);  // fails if the kernel removed it first
        by_id_.erase(it->second);
        it = by_path_.erase(it);
    }
}

void DirectoryWatch::forget(int id) {
    const auto known = by_id_.find(id);
    if (known == by_id_.end()) return;
    by_path_.erase(known->second);
    by_id_.erase(known);
}

std::vector<DirectoryEvent> DirectoryWatch::read() {
    std::vector<DirectoryEvent> events;
    alignas(inotify_event) std::array<char, 1U << 16> buffer;
    for (;;) {
        const ssize_t n = ::read(inotify_.get(), buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EAGAIN) return events;
        if (n < 0) throw_errno("read directory events");
        for (std::size_t at = 0; at < static_cast<std::size_t>(n);) {
            inotify_event head;
            std::memcpy(&head, buffer.data() + at, sizeof head);
            const std::string name = head.len > 0 ? std::string(buffer.data() + at + sizeof head) : "";
            at += sizeof head + head.len;
            if ((head.mask & IN_Q_OVERFLOW) != 0) events.push_back({DirectoryEvent::Kind::overflow, {}, {}});
            const auto known = by_id_.find(head.wd);
            if (known == by_id_.end()) continue;  // the directory was removed in the meantime
            const auto kind = kind_of(head.mask);
            const bool of_itself = name.empty() && kind != DirectoryEvent::Kind::self_gone;
            if (kind && !of_itself) events.push_back({*kind, known->second, name});
            if ((head.mask & IN_IGNORED) != 0) forget(head.wd);
        }
    }
}

}  // namespace vitrine
