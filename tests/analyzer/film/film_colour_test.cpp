// Known coded values through container, decoder and reduction to the sRGB picture that the analysis sees.

#include "tests/analyzer/film/drawn_film.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

constexpr int width = 64;
constexpr int height = 48;
constexpr int tolerance = 3;

using Rgb = std::array<double, 3>;
using Code = std::array<int, 3>;  // Y, Cb, Cr

/// The values of a film of this matrix, range and depth for a colour in [0, 255]. BT.601 to BT.2020.
Code coded(Rgb rgb, double red, double blue, bool is_full, int bits = 8) {
    for (double& value : rgb)
        value /= 255;
    const double luma = red * rgb[0] + (1 - red - blue) * rgb[1] + blue * rgb[2];
    const double scale = 1 << (bits - 8);
    const double cb = (rgb[2] - luma) / (2 * (1 - blue));
    const double cr = (rgb[0] - luma) / (2 * (1 - red));
    const auto whole = [&](double value) { return static_cast<int>(std::lround(value * scale)); };
    if (is_full) return {whole(255 * luma), whole(128 + 255 * cb), whole(128 + 255 * cr)};
    return {whole(16 + 219 * luma), whole(128 + 224 * cb), whole(128 + 224 * cr)};
}

void append(std::vector<std::uint8_t>& picture, int count, int value, int bits) {
    for (int i = 0; i < count; ++i) {
        picture.push_back(static_cast<std::uint8_t>(value & 255));
        if (bits > 8) picture.push_back(static_cast<std::uint8_t>(value >> 8));
    }
}

DrawnFilm plain_film(const Code& code, const std::string& colorimetry, int bits = 8) {
    DrawnFilm film{.caps = fmt::format("width={},height={},format={},colorimetry=(string){}", width, height,
                                       bits > 8 ? "I420_10LE" : "I420", colorimetry)};
    append(film.picture, width * height, code[0], bits);
    append(film.picture, width * height / 4, code[1], bits);
    append(film.picture, width * height / 4, code[2], bits);
    return film;
}

Code shown(const DrawnFilm& film, Colour background = {}) {
    const TemporaryDirectory folder;
    FilmSource source(written(folder, film), 32, background);
    const std::optional<FilmFrame> frame = source.next();
    REQUIRE(frame.has_value());
    const cv::Vec3b middle = frame->picture.at<cv::Vec3b>(frame->picture.rows / 2, frame->picture.cols / 2);
    return {middle[2], middle[1], middle[0]};
}

void check_colour(const Code& seen, const Rgb& expected) {
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(std::abs(seen[i] - expected[i]) <= tolerance);
    }
}

constexpr std::array<Rgb, 4> patches{{{210, 40, 60}, {30, 180, 90}, {50, 70, 200}, {235, 220, 190}}};

}  // namespace

TEST_CASE("a film's colours are its own in BT.601 and BT.709, limited and full range, 8 and 10 bits") {
    for (const Rgb& patch : patches) {
        check_colour(shown(plain_film(coded(patch, 0.299, 0.114, false), "bt601")), patch);
        check_colour(shown(plain_film(coded(patch, 0.2126, 0.0722, false), "bt709")), patch);
        check_colour(shown(plain_film(coded(patch, 0.2126, 0.0722, true), "1:3:5:1")), patch);
        check_colour(shown(plain_film(coded(patch, 0.2126, 0.0722, false, 10), "bt709", 10)), patch);
    }
}

TEST_CASE("a BT.2020 film for usual screens has its wide colours in the screen's") {
    // A colour of BT.709 stands in BT.2020 as less saturated: primaries by BT.2087, both with the same curve.
    constexpr std::array<Rgb, 3> to_wide{
        {{0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0114}, {0.0164, 0.0880, 0.8956}}};
    for (const Rgb& patch : patches) {
        Rgb wide{};
        for (std::size_t row = 0; row < 3; ++row) {
            double light = 0;
            for (std::size_t i = 0; i < 3; ++i)
                light += to_wide[row][i] * std::pow(patch[i] / 255, 2.4);
            wide[row] = 255 * std::pow(light, 1 / 2.4);
        }
        check_colour(shown(plain_film(coded(wide, 0.2627, 0.0593, false, 10), "bt2020-10", 10)), patch);
    }
}

TEST_CASE("paper white of HDR10 and HLG is three quarters of full, and neutral") {
    // 203 cd/m2: 0.5807 in PQ, 0.75 in HLG (BT.2408); 191 of 255 after tone mapping, see tone_map_test.
    constexpr Rgb expected{191, 191, 191};
    const auto code = [](double value) {
        return Code{static_cast<int>(std::lround(64 + 876 * value)), 512, 512};
    };
    for (const auto& [colorimetry, value] : {std::pair{"bt2100-pq", 0.5807}, std::pair{"bt2100-hlg", 0.75}}) {
        const Code seen = shown(plain_film(code(value), colorimetry, 10));
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(std::abs(seen[i] - expected[i]) <= 5);
    }
}

TEST_CASE("the background shows through a film that is transparent") {
    const auto film = [](int alpha) {
        DrawnFilm drawn{
            .caps = fmt::format("width={},height={},format=A420,colorimetry=(string)bt709", width, height)};
        const Code red = coded({210, 40, 60}, 0.2126, 0.0722, false);
        append(drawn.picture, width * height, red[0], 8);
        append(drawn.picture, width * height / 4, red[1], 8);
        append(drawn.picture, width * height / 4, red[2], 8);
        append(drawn.picture, width * height, alpha, 8);
        return drawn;
    };
    constexpr Colour background{.red = 10, .green = 240, .blue = 160};
    check_colour(shown(film(255), background), {210, 40, 60});
    check_colour(shown(film(128), background), {110, 140, 110});
    check_colour(shown(film(0), background), {10, 240, 160});
}
