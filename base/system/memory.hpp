#pragma once

namespace vitrine {

/// Keeps freed blocks, for a process that decodes many frames of megabytes: after each return to the kernel
/// every page would be cleared again. Call it before any thread starts.
void keep_freed_memory();

}  // namespace vitrine
