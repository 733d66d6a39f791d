#pragma once

#include "player/playback/sample.hpp"

#include <gst/gst.h>

#include <chrono>
#include <optional>

namespace vitrine {

/// A decoded RGBA picture lent for as long as the result or a copy of it lives; nothing where its memory
/// cannot be read.
std::optional<Sample> mapped(GstSample* sample, std::chrono::nanoseconds stream_time);

}  // namespace vitrine
