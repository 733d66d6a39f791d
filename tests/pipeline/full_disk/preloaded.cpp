// A disk that is full from one moment on, for tests alone: it stands before the C library's calls and counts
// those that need room below a folder. The environment says of it:
//   FULL_DISK_FOLDER   what is below it needs room
//   FULL_DISK_COUNTER  a file of two numbers of eight bytes: the calls so far, of all processes together, and
//   the
//                      first one that fails, counted from 1, or 0, for calls that are only counted

#include "tests/pipeline/next_call.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace vitrine;

namespace {

struct Calls {
    std::atomic<std::uint64_t> so_far;
    std::atomic<std::uint64_t> first_to_fail;
};

Calls* calls() {
    static auto* const shared = [] {
        const char* file = std::getenv("FULL_DISK_COUNTER");
        const int fd = file == nullptr ? -1 : next("open", &::open)(file, O_RDWR | O_CLOEXEC);
        void* memory = ::mmap(nullptr, sizeof(Calls), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
        ::close(fd);
        return memory == MAP_FAILED ? nullptr : static_cast<Calls*>(memory);
    }();
    return shared;
}

bool is_below(const std::string& path) {
    const char* folder = std::getenv("FULL_DISK_FOLDER");
    return folder != nullptr && path.starts_with(std::string(folder) + "/");
}

/// True: a call that needs room here finds none any more.
bool is_full(const std::string& path) {
    if (!is_below(path) || calls() == nullptr) return false;
    const std::uint64_t number = calls()->so_far.fetch_add(1) + 1;
    const std::uint64_t first = calls()->first_to_fail;
    if (first == 0 || number < first) return false;
    errno = ENOSPC;
    return true;
}

bool makes_file(const std::string& path, int flags) {
    return (flags & O_CREAT) != 0 && ::access(path.c_str(), F_OK) != 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    if (makes_file(path, flags) && is_full(path_at(AT_FDCWD, path))) return -1;
    return next("open", &::open)(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    if (makes_file(path, flags) && is_full(path_at(AT_FDCWD, path))) return -1;
    return next("open64", &::open64)(path, flags, mode);
}

int openat(int folder, const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    const std::string path = path_at(folder, name);
    if (makes_file(path, flags) && is_full(path)) return -1;
    return next("openat", &::openat)(folder, name, flags, mode);
}

int openat64(int folder, const char* name, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = mode_of(flags, arguments);
    va_end(arguments);
    const std::string path = path_at(folder, name);
    if (makes_file(path, flags) && is_full(path)) return -1;
    return next("openat64", &::openat64)(folder, name, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
    const bool makes = mode[0] != 'r' && ::access(path, F_OK) != 0;
    if (makes && is_full(path_at(AT_FDCWD, path))) return nullptr;
    return next("fopen", &::fopen)(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
    const bool makes = mode[0] != 'r' && ::access(path, F_OK) != 0;
    if (makes && is_full(path_at(AT_FDCWD, path))) return nullptr;
    return next("fopen64", &::fopen64)(path, mode);
}

int mkdir(const char* path, mode_t mode) {
    if (::access(path, F_OK) != 0 && is_full(path_at(AT_FDCWD, path))) return -1;
    return next("mkdir", &::mkdir)(path, mode);
}

int mkdirat(int folder, const char* name, mode_t mode) {
    if (::faccessat(folder, name, F_OK, 0) != 0 && is_full(path_at(folder, name))) return -1;
    return next("mkdirat", &::mkdirat)(folder, name, mode);
}

ssize_t write(int fd, const void* bytes, size_t count) {
    if (is_full(path_of(fd))) return -1;
    return next("write", &::write)(fd, bytes, count);
}

ssize_t writev(int fd, const struct iovec* parts, int count) {
    if (is_full(path_of(fd))) return -1;
    return next("writev", &::writev)(fd, parts, count);
}

ssize_t pwrite(int fd, const void* bytes, size_t count, off_t offset) {
    if (is_full(path_of(fd))) return -1;
    return next("pwrite", &::pwrite)(fd, bytes, count, offset);
}

ssize_t pwrite64(int fd, const void* bytes, size_t count, off64_t offset) {
    if (is_full(path_of(fd))) return -1;
    return next("pwrite64", &::pwrite64)(fd, bytes, count, offset);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* file) {
    if (is_full(path_of(::fileno(file)))) return 0;
    return next("fwrite", &::fwrite)(bytes, size, count, file);
}

int fsync(int fd) {
    if (is_full(path_of(fd))) return -1;
    return next("fsync", &::fsync)(fd);
}

int rename(const char* from, const char* to) {
    if (is_full(path_at(AT_FDCWD, to))) return -1;
    return next("rename", &::rename)(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
    if (is_full(path_at(to_folder, to))) return -1;
    return next("renameat", &::renameat)(from_folder, from, to_folder, to);
}

}  // extern "C"
