#include "analyzer/status/status_folder.hpp"

#include "base/system/error.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <memory>

#include <dirent.h>

namespace vitrine::analyzer {

namespace {

constexpr mode_t folder_mode = 0775;
constexpr mode_t file_mode = 0664;

UniqueFd made_below(const UniqueFd& parent, const std::string& name) {
    if (::mkdirat(parent.get(), name.c_str(), folder_mode) < 0 && errno != EEXIST)
        throw_errno("make the folder '{}'", name);
    UniqueFd folder(::openat(parent.get(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!folder.is_open()) throw_errno("open the folder '{}'", name);
    return folder;
}

bool has_content(const UniqueFd& folder, const std::string& name, std::string_view content) {
    const UniqueFd file(::openat(folder.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));

    struct stat status {};

    if (!file.is_open() || ::fstat(file.get(), &status) < 0 || !S_ISREG(status.st_mode)) return false;
    if (static_cast<std::size_t>(status.st_size) != content.size()) return false;
    std::string there(content.size(), '\0');
    return ::pread(file.get(), there.data(), there.size(), 0) == status.st_size && there == content;
}

void write_all(const UniqueFd& file, std::string_view content, const std::string& name) {
    while (!content.empty()) {
        const ssize_t n = ::write(file.get(), content.data(), content.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_errno("write '{}'", name);
        content.remove_prefix(static_cast<std::size_t>(n));
    }
}

struct CloseDirectory {
    void operator()(DIR* directory) const { ::closedir(directory); }
};

}  // namespace

UniqueFd StatusFolder::open(const std::string& below) const {
    const UniqueFd root(::open(root_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!root.is_open()) throw_errno("open '{}'", root_.string());
    UniqueFd folder = made_below(root, name_);
    return below.empty() ? std::move(folder) : made_below(folder, below);
}

void StatusFolder::write(const std::string& below, const std::string& name, std::string_view content) const {
    const UniqueFd folder = open(below);
    if (has_content(folder, name, content)) return;
    const std::string beside = name + ".new";
    ::unlinkat(folder.get(), beside.c_str(), 0);
    const UniqueFd file(::openat(folder.get(), beside.c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, file_mode));
    if (!file.is_open()) throw_errno("create '{}'", beside);
    try {
        write_all(file, content, beside);
        if (::fsync(file.get()) < 0) throw_errno("fsync '{}'", beside);
        if (::renameat(folder.get(), beside.c_str(), folder.get(), name.c_str()) < 0)
            throw_errno("rename '{}'", beside);
    } catch (const std::system_error&) {
        ::unlinkat(folder.get(), beside.c_str(), 0);
        throw;
    }
}

std::set<std::string> StatusFolder::names(const std::string& below, std::string_view ending) const {
    UniqueFd folder = open(below);
    const std::unique_ptr<DIR, CloseDirectory> directory(::fdopendir(folder.get()));
    if (!directory) throw_errno("list '{}'", name_);
    (void)folder.release();  // closedir closes it
    std::set<std::string> names;
    while (const dirent* entry = ::readdir(directory.get()))
        if (std::string_view(entry->d_name).ends_with(ending)) names.insert(entry->d_name);
    return names;
}

void StatusFolder::remove(const std::string& below, const std::string& name) const {
    const UniqueFd folder = open(below);
    if (::unlinkat(folder.get(), name.c_str(), 0) < 0 && errno != ENOENT && errno != EISDIR)
        throw_errno("remove '{}'", name);
}

}  // namespace vitrine::analyzer
