#pragma once

#include <gst/video/video.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vitrine {

/// Brings the pictures of an HDR film, which look grey and flat where they are shown as they are, to what a
/// usual screen shows: paper white of 203 cd/m2 at three quarters of full, highlights up to 1000 cd/m2 below
/// full, colours from BT.2020 to BT.709. A film of BT.2020 colours that is no HDR only has these changed.
/// Tables only: measured 6 ms of processor a megapixel. Source: SMPTE ST 2084, ITU-R BT.2100 and BT.2408,
/// Reinhard et al. 2002 (eq. 4).
class ToneMap {
  public:
    /// Nothing where the film is made for usual screens, colours included.
    static std::optional<ToneMap> of(const GstVideoColorimetry& colours);

    /// @param pixels    8 bits a channel, changed in place
    /// @param channels  3 or 4 a pixel: red, green, blue or blue, green, red; a fourth is left alone
    void apply(std::span<std::uint8_t> pixels, int channels, bool blue_first) const;

  private:
    enum class Curve { usual, perceptual_quantizer, hybrid_log };

    ToneMap(Curve curve, bool wide);

    std::array<std::int32_t, 256> light_{};                  // of a coded value: 0 to full_light, toned down
    std::array<std::array<std::int32_t, 3>, 3> to_bt709_{};  // 1/4096
    std::vector<std::uint8_t> code_;                         // sRGB of 0 to full_light
};

}  // namespace vitrine
