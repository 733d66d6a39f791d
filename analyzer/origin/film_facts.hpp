#pragma once

#include "base/state/media_origin.hpp"

#include <string>

namespace vitrine::analyzer {

/// Reads the time at which an MP4 or MOV was taken, and the identifier of an Apple Live Photo. QuickTime's
/// own date has a zone; that of MP4 is UTC, and counts as taken in the zone of this machine. Does not ask if
/// the time is plausible.
/// @throws MediaError where the file cannot be read
MediaOrigin film_facts(const std::string& path);

}  // namespace vitrine::analyzer
