#include "analyzer/status/status_folder.hpp"

#include "base/system/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdint>
#include <memory>

#include <dirent.h>

namespace vitrine::analyzer {

namespace {

constexpr mode_t folder_mode = 0775;
constexpr mode_t file_mode = 0664;

constexpr std::string_view unfinished_mark = ".vitrine-";  // then 16 hex digits, by chance

std::string unfinished_name() {
    std::uint64_t chance = 0;
    if (::getrandom(&chance, sizeof chance, 0) < 0) throw_errno("draw a number by chance");
    return fmt::format("{}{:016x}", unfinished_mark, chance);
}

bool is_unfinished(std::string_view name) {
    constexpr std::size_t digits = 16;
    return name.size() == unfinished_mark.size() + digits && name.starts_with(unfinished_mark) &&
           name.find_first_not_of("0123456789abcdef", unfinished_mark.size()) == std::string_view::npos;
}

UniqueFd opened_below(const UniqueFd& parent, const std::string& name) {
    return UniqueFd(::openat(parent.get(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

UniqueFd made_below(const UniqueFd& parent, const std::string& name) {
    if (::mkdirat(parent.get(), name.c_str(), folder_mode) < 0 && errno != EEXIST)
        throw_errno("make the folder '{}'", name);
    UniqueFd folder = opened_below(parent, name);
    if (!folder.is_open()) throw_errno("open the folder '{}'", name);
    return folder;
}

/// A folder within ours: a file or link in its place goes.
UniqueFd made_in_ours(const UniqueFd& ours, const std::string& name) {
    struct stat status {};

    if (::fstatat(ours.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISDIR(status.st_mode))
        ::unlinkat(ours.get(), name.c_str(), 0);
    return made_below(ours, name);
}

/// Gives a written file its name. An empty folder in its place goes.
void put_in_place(const UniqueFd& folder, const std::string& written, const std::string& name) {
    const auto renamed = [&] {
        return ::renameat(folder.get(), written.c_str(), folder.get(), name.c_str()) == 0;
    };
    if (renamed()) return;
    const bool is_folder = errno == EISDIR;
    if (is_folder && ::unlinkat(folder.get(), name.c_str(), AT_REMOVEDIR) == 0 && renamed()) return;
    if (is_folder) throw_errno("write '{}', as a folder of that name is in the way", name);
    throw_errno("write '{}'", name);
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
    return below.empty() ? std::move(folder) : made_in_ours(folder, below);
}

void StatusFolder::write(const std::string& below, const std::string& name, std::string_view content) const {
    const UniqueFd folder = open(below);
    if (has_content(folder, name, content)) return;
    const std::string beside = unfinished_name();
    const UniqueFd file(::openat(folder.get(), beside.c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, file_mode));
    if (!file.is_open()) throw_errno("write '{}'", name);
    try {
        write_all(file, content, name);
        if (::fsync(file.get()) < 0) throw_errno("fsync '{}'", name);
        put_in_place(folder, beside, name);
    } catch (const std::system_error&) {
        ::unlinkat(folder.get(), beside.c_str(), 0);
        throw;
    }
}

void StatusFolder::remove_unfinished(const std::string& below) const {
    for (const std::string& name : names(below, ""))
        if (is_unfinished(name)) remove(below, name);
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
