#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vitrine {

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
