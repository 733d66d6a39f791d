#include "base/media/picture.hpp"

#include "base/system/log.hpp"

#include <fmt/format.h>

namespace vitrine {

MediaError picture_failure(PictureFailure failure, std::string_view said) {
    log::debug("picture not read: {}", said);
    switch (failure) {
    case PictureFailure::cut_short:
        return {MediaState::waiting, "the copy is not complete: part of the picture is missing"};
    case PictureFailure::damaged:
        break;
    case PictureFailure::too_large:
        return {MediaState::unsupported, "the picture is too large to be shown"};
    case PictureFailure::unknown_coding:
        return {MediaState::unsupported,
                "the picture is coded in a way that is not read here; save it as JPEG or PNG"};
    }
    return {MediaState::failed, "the picture is damaged"};
}

void require_within_limits(const StillInfo& info) {
    if (info.width > max_still_side || info.height > max_still_side ||
        std::int64_t{info.width} * info.height > max_still_pixels)
        throw MediaError(MediaState::unsupported,
                         fmt::format("the picture is too large: {} x {} px; up to {} megapixels are shown",
                                     info.width, info.height, max_still_pixels / 1'000'000));
}

}  // namespace vitrine
