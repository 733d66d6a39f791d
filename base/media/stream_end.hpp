#pragma once

#include "base/media/media_type.hpp"

#include <string>

namespace vitrine {

/// Refuses a stream that breaks off inside a packet. MPEG-TS does not store its length, so this is the only
/// sign of an incomplete copy. Files of other formats pass.
///
/// A recording that was cut off for good looks the same: do not call this any more after a long enough wait.
/// @throws MediaError waiting
void require_whole_packets(const std::string& path, MediaFormat format);

}  // namespace vitrine
