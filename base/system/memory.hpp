#pragma once

namespace vitrine {

/// Keeps a process that runs for years from growing by fragmentation: limits the arenas of its many threads,
/// and returns freed blocks of pictures to the system. Call it before any thread starts.
void bound_memory();

/// Keeps freed blocks, for a process that decodes many frames of megabytes: after each return to the kernel
/// every page would be cleared again. Call it before any thread starts.
void keep_freed_memory();

}  // namespace vitrine
