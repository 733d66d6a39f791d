#include "analyzer/store/surplus.hpp"

#include <algorithm>
#include <tuple>

namespace vitrine::analyzer {

std::vector<StoredFile> surplus(std::vector<StoredFile> files, std::uint64_t bytes) {
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
