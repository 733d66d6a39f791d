// Calls that fail as they are told, for tests alone: it stands before the C library's calls, so that also
// those fail which no file system is asked for (inotify_add_watch), or for which this machine lacks
// something. The environment says FAILING_CALLS: a file of 64 KiB, mapped at the start, that the test writes
// over. Where its first byte is '1', the lines behind it count: CALL ERRNO PATTERN, with a pattern of
// fnmatch() for absolute paths. CALL is one of open, read, stat, list, watch.

#include "tests/pipeline/next_call.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <sys/inotify.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>

using namespace vitrine;

namespace {

constexpr std::size_t table_bytes = 64UL << 10U;

const volatile char* map_table() {
    const char* file = std::getenv("FAILING_CALLS");
    const int fd = file == nullptr ? -1 : next("open", &::open)(file, O_RDONLY | O_CLOEXEC);
    void* memory = ::mmap(nullptr, table_bytes, PROT_READ, MAP_SHARED, fd, 0);
    if (fd >= 0) ::close(fd);
    return memory == MAP_FAILED ? nullptr : static_cast<const volatile char*>(memory);
}

const volatile char* const table = map_table();

/// True: the call fails, and errno is set. @param path  gives the path; called only while there are faults
template <typename Path> bool fails(const char* call, const Path& path) {
    if (table == nullptr || table[0] != '1') return false;
    const int before = errno;
    std::string text;
    for (std::size_t i = 1; i < table_bytes && table[i] != '\0'; ++i)
        text += table[i];
    std::istringstream lines(text);
    std::string wanted, pattern;
    const std::string name = path();
    for (int error = 0; lines >> wanted >> error >> pattern;) {
        if (wanted != call || ::fnmatch(pattern.c_str(), name.c_str(), 0) != 0) continue;
        errno = error;
        return true;
    }
    errno = before;
    return false;
}

bool open_fails(int folder, const char* name) {
    return fails("open", [&] { return path_at(folder, name); });
}

bool stat_fails(int folder, const char* name) {
    return fails("stat", [&] { return path_at(folder, name); });
}

bool read_fails(int fd) {
    return fails("read", [&] { return path_of(fd); });
}

bool list_fails(DIR* directory) {
    return fails("list", [&] { return path_of(::dirfd(directory)); }) ||
           fails("read", [&] { return path_of(::dirfd(directory)); });
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_fails(AT_FDCWD, path) ? -1 : next("open", &::open)(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_fails(AT_FDCWD, path) ? -1 : next("open64", &::open64)(path, flags, mode);
}

int openat(int folder, const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_fails(folder, name) ? -1 : next("openat", &::openat)(folder, name, flags, mode);
}

int openat64(int folder, const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_fails(folder, name) ? -1 : next("openat64", &::openat64)(folder, name, flags, mode);
}

DIR* opendir(const char* path) {
    return open_fails(AT_FDCWD, path) ? nullptr : next("opendir", &::opendir)(path);
}

struct dirent* readdir(DIR* directory) {
    return list_fails(directory) ? nullptr : next("readdir", &::readdir)(directory);
}

struct dirent64* readdir64(DIR* directory) {
    return list_fails(directory) ? nullptr : next("readdir64", &::readdir64)(directory);
}

ssize_t read(int fd, void* bytes, size_t count) {
    return read_fails(fd) ? -1 : next("read", &::read)(fd, bytes, count);
}

ssize_t pread(int fd, void* bytes, size_t count, off_t offset) {
    return read_fails(fd) ? -1 : next("pread", &::pread)(fd, bytes, count, offset);
}

ssize_t pread64(int fd, void* bytes, size_t count, off64_t offset) {
    return read_fails(fd) ? -1 : next("pread64", &::pread64)(fd, bytes, count, offset);
}

int stat(const char* path, struct stat* status) {
    return stat_fails(AT_FDCWD, path)
               ? -1
               : next("stat", static_cast<int (*)(const char*, struct stat*)>(&::stat))(path, status);
}

int stat64(const char* path, struct stat64* status) {
    return stat_fails(AT_FDCWD, path)
               ? -1
               : next("stat64", static_cast<int (*)(const char*, struct stat64*)>(&::stat64))(path, status);
}

int lstat(const char* path, struct stat* status) {
    return stat_fails(AT_FDCWD, path) ? -1 : next("lstat", &::lstat)(path, status);
}

int lstat64(const char* path, struct stat64* status) {
    return stat_fails(AT_FDCWD, path) ? -1 : next("lstat64", &::lstat64)(path, status);
}

int fstat(int fd, struct stat* status) {
    return stat_fails(fd, "") ? -1 : next("fstat", &::fstat)(fd, status);
}

int fstat64(int fd, struct stat64* status) {
    return stat_fails(fd, "") ? -1 : next("fstat64", &::fstat64)(fd, status);
}

int fstatat(int folder, const char* name, struct stat* status, int flags) {
    return stat_fails(folder, name) ? -1 : next("fstatat", &::fstatat)(folder, name, status, flags);
}

int fstatat64(int folder, const char* name, struct stat64* status, int flags) {
    return stat_fails(folder, name) ? -1 : next("fstatat64", &::fstatat64)(folder, name, status, flags);
}

int statx(int folder, const char* name, int flags, unsigned mask, struct statx* status) {
    if (stat_fails(folder, name)) return -1;
    return next("statx", static_cast<int (*)(int, const char*, int, unsigned, struct statx*)>(&::statx))(
        folder, name, flags, mask, status);
}

int inotify_add_watch(int fd, const char* path, uint32_t mask) {
    if (fails("watch", [&] { return path_at(AT_FDCWD, path); })) return -1;
    return next("inotify_add_watch", &::inotify_add_watch)(fd, path, mask);
}

}  // extern "C"
