#include "analyzer/store/disk_use.hpp"

#include <algorithm>
#include <system_error>
#include <tuple>

namespace vitrine::analyzer {

namespace {

std::int64_t nanoseconds_of(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

std::int64_t used_ns(const struct stat& file) {
    return std::max(nanoseconds_of(file.st_atim), nanoseconds_of(file.st_mtim));
}

std::uint64_t excess_bytes(std::uint64_t held, std::uint64_t max_bytes,
                           const std::filesystem::path& directory, std::uint64_t min_free_bytes) {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(directory, error);
    const std::uint64_t lack =
        error || space.available >= min_free_bytes ? 0 : min_free_bytes - space.available;
    return std::max(held > max_bytes ? held - max_bytes : 0, std::min(held, lack));
}

std::vector<StoredFile> files_to_remove(std::vector<StoredFile> files, std::uint64_t bytes) {
    std::sort(files.begin(), files.end(), [](const StoredFile& a, const StoredFile& b) {
        return std::tie(a.is_named, a.used_ns, a.name) < std::tie(b.is_named, b.used_ns, b.name);
    });
    std::uint64_t freed = 0;
    const auto enough = std::find_if(files.begin(), files.end(), [&](const StoredFile& file) {
        if (freed >= bytes) return true;
        freed += file.bytes;
        return false;
    });
    files.erase(enough, files.end());
    return files;
}

}  // namespace vitrine::analyzer
