#pragma once

namespace vitrine {

/// Keeps a process that runs for years from growing by fragments: it gets few arenas for its many threads,
/// and blocks of pictures go back to the system when they are freed. Call it before any thread starts.
void bound_memory();

/// Keeps freed blocks of a process that decodes many frames of megabytes: each return to the kernel costs it
/// clearing every page again. To be called before any thread starts.
void keep_freed_memory();

}  // namespace vitrine
