#include "base/system/journal_stream.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdlib>

namespace vitrine::log {

bool is_journal(int fd) {
    const char* stream = std::getenv("JOURNAL_STREAM");

    struct stat info {};

    if (stream == nullptr || ::fstat(fd, &info) < 0) return false;
    return fmt::format("{}:{}", info.st_dev, info.st_ino) == stream;
}

}  // namespace vitrine::log
