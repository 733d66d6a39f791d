#pragma once

#include "base/media/media_type.hpp"

#include <string>

namespace vitrine {

/// Refuses a stream that breaks off inside a packet. For formats that nowhere say how long they are, this is
/// all that tells half a copy from a whole one: MPEG-TS, MPEG-PS, Ogg, FLV; others are not looked at.
///
/// A recording that was cut off for good looks the same: after it has been waited for long enough, this is
/// not to be asked.
/// @throws MediaError waiting
void require_whole_packets(const std::string& path, MediaFormat format);

}  // namespace vitrine
