#pragma once

#include "base/state/media_origin.hpp"

#include <chrono>
#include <cstdint>
#include <string>

namespace vitrine::analyzer {

/// Tells when a medium was taken: by its camera if that is plausible, else by the file's own time. A damaged
/// file has its own time, too. Does not throw.
/// @param mtime_ns  the file's modification time
/// @param now       the wall clock
MediaOrigin read_origin(const std::string& path, std::int64_t mtime_ns,
                        std::chrono::system_clock::time_point now);

}  // namespace vitrine::analyzer
