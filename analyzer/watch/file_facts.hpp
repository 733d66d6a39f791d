#pragma once

#include <cstdint>

namespace vitrine::analyzer {

/// The status of one file in the file system.
struct FileFacts {
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;
    std::uint64_t blocks = 0;  // 512 bytes each; with delayed allocation they change after the last write
    std::uint64_t inode = 0;   // not kept by every network file system
    bool is_readable = true;   // this process may read it

    bool operator==(const FileFacts&) const = default;
};

/// True where an analysis of one holds for the other. A record holds no more than this either.
inline bool is_same_content(const FileFacts& a, const FileFacts& b) {
    return a.bytes == b.bytes && a.mtime_ns == b.mtime_ns && a.is_readable == b.is_readable;
}

/// False where another file has come in its place. Some network file systems give a file a new number now and
/// then.
inline bool is_same_file(const FileFacts& a, const FileFacts& b) {
    return a.inode == 0 || b.inode == 0 || a.inode == b.inode;
}

}  // namespace vitrine::analyzer
