#include "base/system/memory.hpp"

#include <malloc.h>

namespace vitrine {

void keep_freed_memory() {
    constexpr int max_kept = 64 << 20;
    constexpr int max_on_heap = 32 << 20;  // the largest value that glibc allows
    ::mallopt(M_TRIM_THRESHOLD, max_kept);
    ::mallopt(M_MMAP_THRESHOLD, max_on_heap);
}

}  // namespace vitrine
