#pragma once

namespace vitrine {

/// Keeps a process that runs for years from growing by fragments: few arenas for its many threads, and blocks
/// of pictures that go back to the system when they are freed. To be called before any thread starts.
void bound_memory();

}  // namespace vitrine
