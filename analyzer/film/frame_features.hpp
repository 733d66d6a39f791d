#pragma once

#include "analyzer/film/black_margins.hpp"
#include "analyzer/film/film_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace vitrine::analyzer {

/// The features of a frame that shot detection keeps: enough to compare it with any other, small enough to
/// keep seconds.
struct FrameFeatures {
    static constexpr std::size_t bins = 8;              // for each colour channel
    static constexpr std::size_t signature_width = 32;  // px
    static constexpr std::size_t signature_height = 18;
    static constexpr std::size_t detail_width = 64;  // px
    static constexpr std::size_t detail_height = 36;

    std::chrono::nanoseconds time{0};
    std::array<std::uint16_t, bins * bins * bins>
        histogram{};  // shares of the picture, the sum is about 65535
    std::array<std::uint8_t, 3 * signature_width * signature_height>
        signature{};                                                  // the picture in BGR, very small
    std::array<std::uint8_t, detail_width * detail_height> detail{};  // the picture in grey, small
    double mean = 0;                                                  // mean of the detail, grey levels
    double deviation = 0;     // standard deviation of the detail, grey levels
    double aspect = 16 / 9.;  // the picture's width over its height
    BlackMargins margins;     // places of the signature
};

FrameFeatures features_of(const FilmFrame& frame);

/// The places of the signature within the black margins that both frames have.
cv::Rect common_part(const FrameFeatures& a, const FrameFeatures& b);

/// Colour histogram difference within the common part: half the sum of absolute differences, in [0, 1].
/// Source: Lienhart's CHD, Dynamic Media Assemblage 3.1.
double colour_difference(const FrameFeatures& a, const FrameFeatures& b);

/// Mean absolute difference of the signatures within the common part, grey levels in [0, 255].
double picture_difference(const FrameFeatures& a, const FrameFeatures& b);

}  // namespace vitrine::analyzer
