#pragma once

namespace vitrine {

/// Keeps a process that runs for years from growing by fragments: it gets few arenas for its many threads,
/// and blocks of pictures go back to the system when they are freed. Call it before any thread starts.
void bound_memory();

}  // namespace vitrine
