#include "tests/player/render/random_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::player {

namespace {

double any(Dice& dice, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
}

/// A channel whose value changes slowly, with or without noise.
struct Channel {
    double middle = 128;
    double swing = 0;
    double noise = 0;
    std::array<std::array<double, 3>, 2> waves{};  // turns across, turns down, phase

    std::byte value(Dice& dice, double across, double down) const {
        double sum = middle;
        for (const auto& [x, y, phase] : waves)
            sum += swing / 2 * std::sin(2 * std::numbers::pi * (x * across + y * down) + phase);
        if (noise > 0) sum += any(dice, -noise, noise);
        return static_cast<std::byte>(std::clamp(std::lround(sum), 0L, 255L));
    }
};

Channel random_channel(Dice& dice, bool is_colour_difference, bool is_noise) {
    Channel channel;
    channel.middle = is_colour_difference ? any(dice, 108, 148) : any(dice, 95, 160);
    channel.swing = is_colour_difference ? any(dice, 0, 40) : any(dice, 20, 75);
    channel.noise = is_noise && !is_colour_difference ? 25 : 0;
    for (auto& wave : channel.waves)
        wave = {any(dice, -0.8, 0.8), any(dice, -0.8, 0.8), any(dice, 0, 6)};
    return channel;
}

/// Fills one plane of a picture.
/// @param at  the place of the first value, the bytes a row, and those from one value to the next
void fill_plane(Still& made, Dice& dice, const Channel& channel, std::array<int, 2> size,
                std::array<std::size_t, 3> at) {
    for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x)
            made.pixels[at[0] + static_cast<std::size_t>(y) * at[1] + static_cast<std::size_t>(x) * at[2]] =
                channel.value(dice, (x + 0.5) / size[0], (y + 0.5) / size[1]);
}

void fill_rgb(Still& made, Dice& dice, std::size_t padding, bool is_noise) {
    const std::array<int, 2> size{made.sample.width, made.sample.height};
    made.sample.stride = (static_cast<std::size_t>(size[0]) + padding) * 4;
    made.pixels.assign(made.sample.stride * static_cast<std::size_t>(size[1]), std::byte{255});
    for (std::size_t i = 0; i < 3; ++i)
        fill_plane(made, dice, random_channel(dice, false, is_noise), size, {i, made.sample.stride, 4});
    made.sample.pixels = made.pixels;
}

void fill_planes(Still& made, Dice& dice, std::size_t padding, bool is_noise) {
    Sample& sample = made.sample;
    const std::array<int, 2> half{(sample.width + 1) / 2, (sample.height + 1) / 2};
    const auto rows = static_cast<std::size_t>(sample.height);
    const auto half_rows = static_cast<std::size_t>(half[1]);
    const bool is_nv12 = sample.layout == PixelLayout::nv12;
    sample.stride = static_cast<std::size_t>(sample.width) + padding;
    const std::size_t stride = (static_cast<std::size_t>(half[0]) + padding) * (is_nv12 ? 2 : 1);
    const std::size_t whole = sample.stride * rows;
    made.pixels.assign(whole + 2 * stride * half_rows, std::byte{128});
    fill_plane(made, dice, random_channel(dice, false, is_noise), {sample.width, sample.height},
               {0, sample.stride, 1});
    for (std::size_t i = 0; i < 2; ++i)
        fill_plane(made, dice, random_channel(dice, true, is_noise), half,
                   {whole + (is_nv12 ? i : i * stride * half_rows), stride, is_nv12 ? 2U : 1U});
    const std::span<const std::byte> bytes = made.pixels;
    sample.pixels = bytes.first(whole);
    sample.chroma[0] = {stride, bytes.subspan(whole, stride * half_rows)};
    if (!is_nv12) sample.chroma[1] = {stride, bytes.subspan(whole + stride * half_rows, stride * half_rows)};
}

}  // namespace

RandomPicture random_picture(Dice& dice, int width, int height, const RandomFrame& frame) {
    constexpr std::array layouts{PixelLayout::bgra, PixelLayout::bgra, PixelLayout::rgba, PixelLayout::i420,
                                 PixelLayout::nv12};
    constexpr std::array matrices{ColourCode::Matrix::bt601, ColourCode::Matrix::bt709,
                                  ColourCode::Matrix::bt2020};
    RandomPicture made;
    made.is_film = dice() % 2 == 0;
    made.still.sample = {.width = width,
                         .height = height,
                         .layout = layouts[dice() % (frame.has_planes ? layouts.size() : 3)]};
    made.still.sample.colours = {matrices[dice() % matrices.size()], dice() % 2 == 0};
    const std::size_t padding = dice() % 2 == 0 ? 0 : dice() % 9;
    if (is_rgb(made.still.sample.layout))
        fill_rgb(made.still, dice, padding, frame.is_noise);
    else
        fill_planes(made.still, dice, padding, frame.is_noise);
    return made;
}

}  // namespace vitrine::player
