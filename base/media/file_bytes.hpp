#pragma once

#include "base/state/media_error.hpp"
#include "base/system/unique_fd.hpp"
#include "base/system/written_size.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace vitrine {

/// Reads bytes of a file without decoding them. Each reading throws a MediaError if the call fails: that is a
/// fault of transport or machine, not of the file.
class FileBytes {
  public:
    /// @throws MediaError a fault of transport or machine if the file cannot be opened
    explicit FileBytes(const std::string& path)
        : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        struct stat status {};

        if (!fd_.is_open() || ::fstat(fd_.get(), &status) != 0)
            throw failed_call("the file cannot be opened", errno);
        size_ = static_cast<std::uint64_t>(status.st_size);
    }

    std::uint64_t size() const { return size_; }

    /// The bytes before the hole at the end of the file, or all bytes if there is none.
    std::uint64_t written() const { return written_size(fd_.get()); }

    /// N bytes. None: they reach beyond the end.
    template <std::size_t N> std::optional<std::array<std::uint8_t, N>> at(std::uint64_t offset) const {
        std::array<std::uint8_t, N> bytes{};
        if (read(offset, std::as_writable_bytes(std::span(bytes))) < N) return std::nullopt;
        return bytes;
    }

    /// Fills `to` with the bytes from `offset` on.
    /// @return how many there are; fewer than `to` holds only at the end of the file
    std::size_t read(std::uint64_t offset, std::span<std::byte> to) const {
        std::size_t filled = 0;
        while (filled < to.size()) {
            const ssize_t got = ::pread(fd_.get(), to.data() + filled, to.size() - filled,
                                        static_cast<off_t>(offset + filled));
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) throw failed_call("the file cannot be read", errno);
            if (got == 0) break;
            filled += static_cast<std::size_t>(got);
        }
        return filled;
    }

  private:
    UniqueFd fd_;
    std::uint64_t size_ = 0;
};

/// Reads all of a file and forgets it. @throws MediaError a fault of transport or machine
void require_readable(const std::string& path);

/// A number whose first byte is the highest. @tparam Byte  char, std::uint8_t or std::byte
template <typename Byte> constexpr std::uint64_t big_endian(std::span<const Byte> bytes) {
    std::uint64_t value = 0;
    for (const Byte byte : bytes)
        value = value << 8U | static_cast<std::uint8_t>(byte);
    return value;
}

/// A number whose first byte is the lowest.
template <typename Byte> constexpr std::uint64_t little_endian(std::span<const Byte> bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i > 0; --i)
        value = value << 8U | static_cast<std::uint8_t>(bytes[i - 1]);
    return value;
}

/// The number of `count` bytes from `from` on; they lie within the bytes.
template <typename Bytes>
constexpr std::uint64_t big_endian(const Bytes& bytes, std::size_t from, std::size_t count) {
    return big_endian(std::span<const typename Bytes::value_type>(bytes).subspan(from, count));
}

template <typename Bytes>
constexpr std::uint64_t little_endian(const Bytes& bytes, std::size_t from, std::size_t count) {
    return little_endian(std::span<const typename Bytes::value_type>(bytes).subspan(from, count));
}

}  // namespace vitrine
