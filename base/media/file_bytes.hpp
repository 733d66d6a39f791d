#pragma once

#include "base/state/media_error.hpp"
#include "base/system/unique_fd.hpp"
#include "base/system/written_size.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>

namespace vitrine {

/// Reads single bytes of a file without decoding it.
class FileBytes {
  public:
    /// @throws MediaError failed if the file cannot be opened
    explicit FileBytes(const std::string& path)
        : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        struct stat status {};

        if (!fd_.is_open() || ::fstat(fd_.get(), &status) != 0)
            throw MediaError(MediaState::failed, fmt::format("the file cannot be opened: {}",
                                                             std::generic_category().message(errno)));
        size_ = static_cast<std::uint64_t>(status.st_size);
    }

    std::uint64_t size() const { return size_; }

    /// The bytes before the hole at the end of the file, or all bytes if there is none.
    std::uint64_t written() const { return written_size(fd_.get()); }

    /// N bytes. None: they reach beyond the end.
    template <std::size_t N> std::optional<std::array<std::uint8_t, N>> at(std::uint64_t offset) const {
        std::array<std::uint8_t, N> bytes{};
        const ssize_t got = ::pread(fd_.get(), bytes.data(), N, static_cast<off_t>(offset));
        if (got != static_cast<ssize_t>(N)) return std::nullopt;
        return bytes;
    }

    /// The last bytes of the file, at most max_bytes.
    std::string tail(std::size_t max_bytes) const {
        std::string bytes(std::min<std::uint64_t>(max_bytes, size_), '\0');
        const ssize_t got =
            ::pread(fd_.get(), bytes.data(), bytes.size(), static_cast<off_t>(size_ - bytes.size()));
        bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        return bytes;
    }

  private:
    UniqueFd fd_;
    std::uint64_t size_ = 0;
};

}  // namespace vitrine
