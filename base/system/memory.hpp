#pragma once

#include <chrono>
#include <functional>

namespace vitrine {

/// Keeps a process that runs for years from growing by fragmentation: limits the arenas of its many threads,
/// and returns freed blocks of pictures to the system. Call it before any thread starts.
void bound_memory();

/// Keeps freed blocks, for a process that decodes many frames of megabytes: after each return to the kernel
/// every page would be cleared again. Call it before any thread starts.
void keep_freed_memory();

/// Returns freed memory to the system from time to time. Without it, free pages between blocks that are in
/// use stay with the process, and its memory grows for hours until the blocks lie as badly as they can.
class FreedMemory {
  public:
    /// @param return_all  returns all free pages; it takes some milliseconds, in which no other thread
    /// allocates
    explicit FreedMemory(std::function<void()> return_all);

    /// Call it often. @param now  any steady time
    void look(std::chrono::nanoseconds now);

  private:
    std::function<void()> return_all_;
    std::chrono::nanoseconds due_;
};

/// Returns all free pages of this process to the system.
void return_freed_memory();

}  // namespace vitrine
