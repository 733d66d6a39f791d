#include "analyzer/store/disk_use.hpp"

#include <algorithm>
#include <system_error>

namespace vitrine::analyzer {

namespace {

std::int64_t nanoseconds_of(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

std::int64_t used_ns(const struct stat& file) {
    return std::max(nanoseconds_of(file.st_atim), nanoseconds_of(file.st_mtim));
}

std::uint64_t excess_bytes(std::uint64_t held, std::uint64_t most, const std::filesystem::path& directory,
                           std::uint64_t min_free_bytes) {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(directory, error);
    const std::uint64_t lack =
        error || space.available >= min_free_bytes ? 0 : min_free_bytes - space.available;
    return std::max(held > most ? held - most : 0, std::min(held, lack));
}

}  // namespace vitrine::analyzer
