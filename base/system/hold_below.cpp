#include "base/system/hold_below.hpp"

#include "base/system/error.hpp"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <cerrno>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

constexpr int hold = O_PATH | O_CLOEXEC;

/// @return not open, with errno, where the kernel refuses
UniqueFd held_at_once(const UniqueFd& root, const fs::path& path) {
    open_how how{};
    how.flags = hold;
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS;
    return UniqueFd(static_cast<int>(::syscall(SYS_openat2, root.get(), path.c_str(), &how, sizeof how)));
}

/// The same where there is no openat2: before Linux 5.6, or because a filter of calls does not know it.
UniqueFd held_step_by_step(const UniqueFd& root, const fs::path& path) {
    UniqueFd at(::fcntl(root.get(), F_DUPFD_CLOEXEC, 0));
    for (const fs::path& part : path) {
        UniqueFd next(::openat(at.get(), part.c_str(), hold | O_NOFOLLOW));

        struct stat status {};

        if (!next.is_open() || ::fstat(next.get(), &status) != 0) return {};
        if (S_ISLNK(status.st_mode)) {
            errno = ELOOP;
            return {};
        }
        at = std::move(next);
    }
    return at;
}

}  // namespace

UniqueFd hold_below(const fs::path& root, const fs::path& path) {
    const UniqueFd folder(::open(root.c_str(), hold | O_DIRECTORY));
    if (!folder.is_open()) throw_errno("look at '{}'", root.string());
    UniqueFd file = held_at_once(folder, path);
    if (!file.is_open() && (errno == ENOSYS || errno == EPERM)) file = held_step_by_step(folder, path);
    if (!file.is_open()) throw_errno("look at '{}'", (root / path).string());
    return file;
}

}  // namespace vitrine
