#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace vitrine {

/// The size of a coded picture, px.
struct CodedSize {
    int width = 0;
    int height = 0;

    bool operator==(const CodedSize&) const = default;
};

/// The size that a coded picture of VP8 or VP9 states in its own header. These two have no parser in the
/// pipeline, so that the caps of the stream do not tell of another size. Several VP9 pictures in one buffer:
/// the largest.
/// @param codec    the name of the stream's caps: "video/x-vp8"
/// @param picture  one buffer of the stream
/// @return  none: the picture has the size of an earlier one, its header is cut off, or the codec is another
/// one
std::optional<CodedSize> coded_size(std::string_view codec, std::span<const std::uint8_t> picture);

}  // namespace vitrine
