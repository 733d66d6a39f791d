#pragma once

// For libraries that stand before the C library's calls: the call that they stand before, and the path that a
// call is about.

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <climits>
#include <cstdarg>
#include <cstddef>
#include <string>

namespace vitrine {

/// The C library's own call of that name. @param  its type
template <typename Call> Call next(const char* name, Call) {
    return reinterpret_cast<Call>(::dlsym(RTLD_NEXT, name));
}

inline std::string link_target(const std::string& link) {
    std::string target(PATH_MAX, '\0');
    const ssize_t length = ::readlink(link.c_str(), target.data(), target.size());
    target.resize(length < 0 ? 0 : static_cast<std::size_t>(length));
    return target;
}

inline std::string path_of(int fd) {
    return link_target("/proc/self/fd/" + std::to_string(fd));
}

/// @param name  empty or null: the folder itself
inline std::string path_at(int folder, const char* name) {
    if (name == nullptr || *name == '\0') return path_of(folder);
    if (*name == '/') return name;
    return (folder == AT_FDCWD ? link_target("/proc/self/cwd") : path_of(folder)) + "/" + name;
}

/// The third argument of open().
inline int mode_of(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, int) : 0;
}

}  // namespace vitrine
