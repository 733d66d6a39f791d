#include "base/system/atomic_file.hpp"

#include "base/system/error.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <array>

namespace vitrine {

namespace {

void write_all(int fd, std::string_view content, const std::string& name) {
    while (!content.empty()) {
        const ssize_t n = ::write(fd, content.data(), content.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_errno("write '{}'", name);
        content.remove_prefix(static_cast<std::size_t>(n));
    }
}

UniqueFd write_new(const std::string& name, std::string_view content) {
    UniqueFd fd(::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!fd.is_open()) throw_errno("create '{}'", name);
    write_all(fd.get(), content, name);
    return fd;
}

void write_and_sync(const std::string& name, std::string_view content) {
    const UniqueFd fd = write_new(name, content);
    if (::fsync(fd.get()) < 0) throw_errno("fsync '{}'", name);
}

void sync_directory(const std::string& name) {
    const UniqueFd fd(::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!fd.is_open()) throw_errno("open '{}'", name);
    if (::fsync(fd.get()) < 0) throw_errno("fsync '{}'", name);
}

void rename_and_sync(const std::string& written, const std::filesystem::path& path) {
    if (::rename(written.c_str(), path.c_str()) < 0) throw_errno("rename '{}'", written);
    const std::filesystem::path parent = path.parent_path();
    sync_directory(parent.empty() ? "." : parent.string());
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view content) {
    const std::string sibling = unfinished(path).string();
    try {
        write_and_sync(sibling, content);
        rename_and_sync(sibling, path);
    } catch (const std::system_error&) {
        ::unlink(sibling.c_str());
        throw;
    }
}

void replace_file_unsynced(const std::filesystem::path& path, std::string_view content) {
    const std::string sibling = unfinished(path).string();
    try {
        write_new(sibling, content);
        if (::rename(sibling.c_str(), path.c_str()) < 0) throw_errno("rename '{}'", sibling);
    } catch (const std::system_error&) {
        ::unlink(sibling.c_str());
        throw;
    }
}

void publish_file(const std::filesystem::path& written, const std::filesystem::path& path) {
    try {
        const UniqueFd fd(::open(written.c_str(), O_RDONLY | O_CLOEXEC));
        if (!fd.is_open()) throw_errno("open '{}'", written.string());
        if (::fsync(fd.get()) < 0) throw_errno("fsync '{}'", written.string());
        rename_and_sync(written.string(), path);
    } catch (const std::system_error&) {
        ::unlink(written.c_str());
        throw;
    }
}

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!fd.is_open()) throw_errno("open '{}'", path.string());
    std::string content;
    std::array<char, 1U << 16> buffer;
    for (;;) {
        const ssize_t n = ::read(fd.get(), buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_errno("read '{}'", path.string());
        if (n == 0) return content;
        content.append(buffer.data(), static_cast<std::size_t>(n));
        if (content.size() > max_bytes) {
            errno = EFBIG;
            throw_errno("read '{}'", path.string());
        }
    }
}

}  // namespace vitrine
