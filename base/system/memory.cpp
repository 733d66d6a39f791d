#include "base/system/memory.hpp"

#include <malloc.h>

#include <utility>

namespace vitrine {

namespace {

constexpr auto return_interval = std::chrono::minutes(5);
constexpr int arenas = 2;
constexpr int returned_from = 32 << 10;  // bytes; otherwise the limit grows to the largest block ever freed

}  // namespace

void bound_memory() {
    ::mallopt(M_ARENA_MAX, arenas);
    ::mallopt(M_MMAP_THRESHOLD, returned_from);
    ::mallopt(M_TRIM_THRESHOLD, 4 * returned_from);
}

void keep_freed_memory() {
    constexpr int max_kept = 64 << 20;
    constexpr int max_on_heap = 32 << 20;  // the largest value that glibc allows
    ::mallopt(M_TRIM_THRESHOLD, max_kept);
    ::mallopt(M_MMAP_THRESHOLD, max_on_heap);
}

FreedMemory::FreedMemory(std::function<void()> return_all)
    : return_all_(std::move(return_all)), due_(return_interval) {}

void FreedMemory::look(std::chrono::nanoseconds now) {
    if (now < due_) return;
    due_ = now + return_interval;
    return_all_();
}

void return_freed_memory() {
    ::malloc_trim(0);
}

}  // namespace vitrine
