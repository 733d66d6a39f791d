#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// A file of the store as its bounds see it.
struct StoredFile {
    std::string name;
    std::uint64_t bytes = 0;
    std::int64_t used_ns = 0;  // when it was made or last read, since 1970
    bool is_named = false;     // by a record

    friend bool operator==(const StoredFile&, const StoredFile&) = default;
};

/// Which files have to go so that so many bytes become free: first those that no record names, then those
/// that are named, the one that was not used for longest first. All of them where that is not enough.
std::vector<StoredFile> surplus(std::vector<StoredFile> files, std::uint64_t bytes);

}  // namespace vitrine::analyzer
