#include "base/media/file_bytes.hpp"

#include <vector>

namespace vitrine {

void require_readable(const std::string& path) {
    constexpr std::size_t step = 1U << 20;
    const FileBytes file(path);
    std::vector<std::byte> bytes(step);
    for (std::uint64_t at = 0; at < file.size(); at += step)
        file.read(at, bytes);
}

}  // namespace vitrine
