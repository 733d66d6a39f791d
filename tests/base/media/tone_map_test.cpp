#include "base/media/tone_map.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>

using namespace vitrine;

namespace {

GstVideoColorimetry colours(GstVideoTransferFunction transfer) {
    return {GST_VIDEO_COLOR_RANGE_16_235, GST_VIDEO_COLOR_MATRIX_BT2020, transfer,
            GST_VIDEO_COLOR_PRIMARIES_BT2020};
}

std::array<std::uint8_t, 3> mapped(GstVideoTransferFunction transfer, std::array<std::uint8_t, 3> pixel) {
    ToneMap::of(colours(transfer))->apply(pixel, 3, false);
    return pixel;
}

}  // namespace

TEST_CASE("a film for usual screens is left as it is") {
    for (const auto transfer : {GST_VIDEO_TRANSFER_BT709, GST_VIDEO_TRANSFER_UNKNOWN}) {
        GstVideoColorimetry usual = colours(transfer);
        usual.primaries = GST_VIDEO_COLOR_PRIMARIES_BT709;
        CHECK_FALSE(ToneMap::of(usual));
    }
}

TEST_CASE("HDR's paper white is bright, its black black and its peak full, of both kinds") {
    // 203 cd/m2 is coded as 0.58 in PQ and 0.75 in HLG (BT.2408); eq. 4 of Reinhard makes it 0.52 of full
    // light, which is 0.75 in sRGB.
    struct Kind {
        GstVideoTransferFunction transfer;
        int white;
        int peak;
    };

    for (const Kind& kind :
         {Kind{GST_VIDEO_TRANSFER_SMPTE2084, 148, 193}, Kind{GST_VIDEO_TRANSFER_ARIB_STD_B67, 191, 255}}) {
        const auto grey = [&](int value) {
            const auto level = static_cast<std::uint8_t>(value);
            const auto pixel = mapped(kind.transfer, {level, level, level});
            CHECK(std::abs(pixel[0] - pixel[1]) <= 1);
            CHECK(std::abs(pixel[2] - pixel[1]) <= 1);
            return int{pixel[1]};
        };
        CHECK(grey(0) == 0);
        CHECK(std::abs(grey(kind.white) - 191) <= 5);
        CHECK(grey(kind.peak) >= 252);
        for (int value = 1; value < 256; ++value)
            CHECK(grey(value) >= grey(value - 1));
    }
}

TEST_CASE("wide colours become richer, and the order of channels does not matter") {
    const std::array<std::uint8_t, 3> sky{90, 110, 140};
    const auto rgb = mapped(GST_VIDEO_TRANSFER_SMPTE2084, sky);
    CHECK(rgb[2] - rgb[0] > sky[2] - sky[0]);
    std::array<std::uint8_t, 4> bgra{sky[2], sky[1], sky[0], 77};
    ToneMap::of(colours(GST_VIDEO_TRANSFER_SMPTE2084))->apply(bgra, 4, true);
    CHECK(bgra == std::array<std::uint8_t, 4>{rgb[2], rgb[1], rgb[0], 77});
}
