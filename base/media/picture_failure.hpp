#pragma once

#include "base/media/picture.hpp"
#include "base/state/media_error.hpp"

#include <string_view>

namespace vitrine {

/// The reasons why a photo is not shown, as far as they matter to the person who put it there.
enum class PictureFailure { cut_short, damaged, too_large, unknown_coding };

/// The state and the text of a failure. The library's own text goes to the debug log: operators cannot use
/// it.
MediaError picture_failure(PictureFailure failure, std::string_view said);

/// @throws MediaError if a photo of this size is too large
void require_within_limits(const StillInfo& info);

}  // namespace vitrine
