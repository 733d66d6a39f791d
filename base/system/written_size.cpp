#include "base/system/written_size.hpp"

#include <unistd.h>

#include <cerrno>

namespace vitrine {

namespace {

constexpr int max_extents = 100'000;  // in one file; a file with more counts as written

}  // namespace

std::uint64_t written_size(int fd) {
    const off_t size = ::lseek(fd, 0, SEEK_END);
    if (size <= 0) return 0;
    off_t written = 0;
    for (int i = 0; i < max_extents && written < size; ++i) {
        const off_t data = ::lseek(fd, written, SEEK_DATA);
        if (data < 0 && errno == ENXIO)
            return static_cast<std::uint64_t>(written);  // from here on there is only a hole
        const off_t hole = data < 0 ? -1 : ::lseek(fd, data, SEEK_HOLE);
        if (hole < 0) break;
        written = hole;
    }
    return static_cast<std::uint64_t>(size);
}

}  // namespace vitrine
