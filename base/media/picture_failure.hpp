#pragma once

#include "base/media/picture.hpp"
#include "base/state/media_error.hpp"

#include <string_view>

namespace vitrine {

/// Why a photo is not shown, as far as it matters to who put it there.
enum class PictureFailure { cut_short, damaged, too_large, unknown_coding };

/// State and words of a failure. What the library said goes to the debug log: the operator cannot use it.
MediaError picture_failure(PictureFailure failure, std::string_view said);

/// @throws MediaError where a photo of this size is too large
void require_within_limits(const StillInfo& info);

}  // namespace vitrine
