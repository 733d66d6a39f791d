#include "tests/player/render/reference_picture.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double small = 1.5;         // texels a canvas px from which photos are drawn from smaller copies
constexpr double same_extent = 0.75;  // canvas px

double mirrored(double place) {
    const double turn = place - 2 * std::floor(place / 2);
    return turn <= 1 ? turn : 2 - turn;
}

/// Where the mirrors of one axis stand. A mirror at a bar stands a texel of the smaller copy away from it.
std::array<double, 2> mirrors(double from, double to, double texel) {
    const double first = from > 0 ? from + texel : from;
    const double last = to < 1 ? to - texel : to;
    return {first, last};
}

/// The light of red and blue in the brightness of a film.
std::array<double, 2> shares_of(ColourCode::Matrix matrix) {
    switch (matrix) {
    case ColourCode::Matrix::bt709:
        return {0.2126, 0.0722};
    case ColourCode::Matrix::bt2020:
        return {0.2627, 0.0593};
    case ColourCode::Matrix::bt601:
        break;
    }
    return {0.299, 0.114};
}

}  // namespace

double ReferencePicture::Level::texel(int x, int y) const {
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, width - 1));
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, height - 1));
    return values[row * static_cast<std::size_t>(width) + column];
}

double ReferencePicture::Level::at(Vec2 place) const {
    const double x = place.x * width - 0.5;
    const double y = place.y * height - 0.5;
    const double left = std::floor(std::clamp(x, -1.0, width + 0.0));
    const double top = std::floor(std::clamp(y, -1.0, height + 0.0));
    const double right_share = std::clamp(x - left, 0.0, 1.0);
    const double low_share = std::clamp(y - top, 0.0, 1.0);
    const int column = static_cast<int>(left);
    const int row = static_cast<int>(top);
    const double upper = texel(column, row) * (1 - right_share) + texel(column + 1, row) * right_share;
    const double lower =
        texel(column, row + 1) * (1 - right_share) + texel(column + 1, row + 1) * right_share;
    return upper * (1 - low_share) + lower * low_share;
}

ReferencePicture::ReferencePicture(const Sample& sample, bool is_film)
    : width_(sample.width),
      height_(sample.height),
      slide_(sample.slide),
      is_rgb_(player::is_rgb(sample.layout)),
      is_film_(is_film),
      code_(sample.colours) {
    const Sample::Plane whole{sample.stride, sample.pixels};
    if (is_rgb_) {
        const bool is_red_first = sample.layout == PixelLayout::rgba;
        for (std::size_t channel = 0; channel < 3; ++channel)
            add_channel(whole, width_, height_, {4, is_red_first ? channel : 2 - channel});
        return;
    }
    const int across = (width_ + 1) / 2;
    const int down = (height_ + 1) / 2;
    add_channel(whole, width_, height_, {1, 0});
    const bool is_nv12 = sample.layout == PixelLayout::nv12;
    add_channel(sample.chroma[0], across, down, {is_nv12 ? 2U : 1U, 0});
    add_channel(sample.chroma[is_nv12 ? 0 : 1], across, down, {is_nv12 ? 2U : 1U, is_nv12 ? 1U : 0U});
}

/// @param bytes  distance of two texels in a row, and the place of the channel in the first
void ReferencePicture::add_channel(const Sample::Plane& plane, int width, int height,
                                   std::array<std::size_t, 2> bytes) {
    Level whole{.width = width, .height = height, .values = {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t place = static_cast<std::size_t>(y) * plane.stride +
                                      static_cast<std::size_t>(x) * bytes[0] + bytes[1];
            whole.values.push_back(std::to_integer<int>(plane.bytes[place]) / 255.0);
        }
    channels_.at(count_++) = smaller_copies(std::move(whole));
}

ReferencePicture::Channel ReferencePicture::smaller_copies(Level whole) {
    Channel levels;
    levels.push_back(std::move(whole));
    while (levels.back().width > 1 || levels.back().height > 1) {
        const Level& larger = levels.back();
        Level next{
            .width = std::max(1, larger.width / 2), .height = std::max(1, larger.height / 2), .values = {}};
        for (int y = 0; y < next.height; ++y)
            for (int x = 0; x < next.width; ++x)
                next.values.push_back(larger.at({(x + 0.5) / next.width, (y + 0.5) / next.height}));
        levels.push_back(std::move(next));
    }
    return levels;
}

void ReferencePicture::aim(const DrawItem& item, Vec2 px, bool is_on_pixels) {
    const Vec2 shown = item.picture * item.placement.scale;
    if (width_ / shown.x >= small && !is_film_) has_smaller_copies_ = true;
    is_exact_ = is_on_pixels && is_rgb_ && slide_ * item.slide_share == Vec2{} &&
                std::abs(shown.x - width_) < same_extent && std::abs(shown.y - height_) < same_extent;
    for (std::size_t i = 0; i < 3; ++i) {
        const Level& whole = channels_[i].front();
        const double texels = std::max(whole.width / (shown.x * px.x), whole.height / (shown.y * px.y));
        const double nearest = std::ceil(std::log2(texels) + 0.5) - 1;
        levels_[i] = has_smaller_copies_ && !is_exact_ ? std::max(0.0, nearest) : 0;
    }
}

double ReferencePicture::sampled(const Channel& channel, Vec2 place, double level) const {
    const auto copy = std::min(static_cast<std::size_t>(level), channel.size() - 1);
    return channel[copy].at(place);
}

Rgb ReferencePicture::at(Vec2 place) const {
    std::array<double, 3> coded{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Level& whole = channels_[i].front();
        coded[i] = is_exact_ ? whole.texel(static_cast<int>(std::floor(place.x * whole.width)),
                                           static_cast<int>(std::floor(place.y * whole.height)))
                             : sampled(channels_[i], place, levels_[i]);
    }
    return colour_of(coded);
}

Rgb ReferencePicture::filler_at(Vec2 place, const Box& active, double light) const {
    constexpr int taps = 16;
    constexpr double turn = 2.39996323;  // the golden angle
    const double radius = 0.25 * std::min(width_, height_);
    const double level = std::max(0.0, std::ceil(std::log2(radius) - 1 + 0.5) - 1);
    auto [left, right] = mirrors(active.min.x, active.max.x, radius / 2 / width_);
    auto [top, bottom] = mirrors(active.min.y, active.max.y, radius / 2 / height_);
    if (left >= right || top >= bottom) {  // no room
        left = active.min.x, right = active.max.x;
        top = active.min.y, bottom = active.max.y;
    }
    Rgb sum{};
    for (int tap = 0; tap < taps; ++tap) {
        const double far = std::sqrt((tap + 0.5) / taps) * radius;
        const Vec2 to{place.x + std::cos(tap * turn) * far / width_,
                      place.y + std::sin(tap * turn) * far / height_};
        std::array<double, 3> coded{};
        for (std::size_t i = 0; i < 3; ++i)
            coded[i] = sampled(channels_[i],
                               {left + (right - left) * mirrored((to.x - left) / (right - left)),
                                top + (bottom - top) * mirrored((to.y - top) / (bottom - top))},
                               level);
        const Rgb colour = colour_of(coded);
        for (std::size_t i = 0; i < 3; ++i)
            sum[i] += colour[i] * light / taps;
    }
    return sum;
}

Rgb ReferencePicture::colour_of(const std::array<double, 3>& coded) const {
    if (is_rgb_) return coded;
    const auto [red, blue] = shares_of(code_.matrix);
    const double black = code_.is_full_range ? 0 : 16.0 / 255;
    const double y = (coded[0] - black) / (code_.is_full_range ? 1 : 219.0 / 255);
    const double reach = code_.is_full_range ? 1 : 224.0 / 255;
    const double b = y + 2 * (1 - blue) * (coded[1] - 128.0 / 255) / reach;
    const double r = y + 2 * (1 - red) * (coded[2] - 128.0 / 255) / reach;
    return {r, (y - red * r - blue * b) / (1 - red - blue), b};
}

}  // namespace vitrine::player
