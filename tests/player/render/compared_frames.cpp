#include "tests/player/render/compared_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int block_side = 16;
constexpr int min_counted = 64;  // pixels of a block beside its edges

/// Looks for the largest differences of two pictures.
class Search {
  public:
    Search(const Picture& drawn, const ReferenceImage& expected) : drawn_(drawn), expected_(expected) {}

    void look_at_pixels() {
        for (int y = 0; y < expected_.height; ++y)
            for (int x = 0; x < expected_.width; ++x) {
                const bool is_edge = expected_.is_edge[expected_.index(x, y)];
                if (is_edge)
                    for (std::size_t i = 0; i < 3; ++i)
                        note(found_.at_edges, from_near(x, y, i) - blends(x, y), {x, y});
                else
                    look_at_pixel(x, y);
            }
    }

    void look_at_blocks() {
        for (int y = 0; y < expected_.height; y += block_side)
            for (int x = 0; x < expected_.width; x += block_side)
                for (std::size_t i = 0; i < 3; ++i)
                    note(found_.blocks, block(x, y, i), {x, y});
    }

    Deviation found() const { return found_; }

  private:
    void look_at_pixel(int x, int y) {
        double colour = 0;
        for (std::size_t i = 0; i < 3; ++i)
            colour = std::max(colour, std::abs(off(x, y, i)));
        const double grey = std::abs(0.299 * off(x, y, 0) + 0.587 * off(x, y, 1) + 0.114 * off(x, y, 2));
        note(found_.colour, colour - blends(x, y), {x, y});
        note(found_.grey, grey - blends(x, y), {x, y});
    }

    int blends(int x, int y) const { return expected_.blends[expected_.index(x, y)]; }

    void note(double& largest, double value, std::array<int, 2> place) {
        if (value > found_.worst()) found_.place = fmt::format("at {}, {}", place[0], place[1]);
        largest = std::max(largest, value);
    }

    double value(int x, int y, std::size_t channel) const {
        return std::to_integer<int>(drawn_.pixels[expected_.index(x, y) * 4 + channel]);
    }

    double off(int x, int y, std::size_t channel) const {
        return value(x, y, channel) - expected_.at(x, y)[channel] * 255;
    }

    /// The distance of a value from all that the reference drew within 1 px.
    double from_near(int x, int y, std::size_t channel) const {
        double low = 255;
        double high = 0;
        for (int row = std::max(0, y - 1); row <= std::min(expected_.height - 1, y + 1); ++row)
            for (int column = std::max(0, x - 1); column <= std::min(expected_.width - 1, x + 1); ++column) {
                const std::size_t index = expected_.index(column, row);
                low = std::min<double>(low, expected_.low[index][channel] * 255);
                high = std::max<double>(high, expected_.high[index][channel] * 255);
            }
        const double here = value(x, y, channel);
        return std::max({0.0, low - here, here - high});
    }

    double block(int left, int top, std::size_t channel) const {
        double sum = 0;
        double rounded = 0;
        int count = 0;
        for (int y = top; y < std::min(top + block_side, expected_.height); ++y)
            for (int x = left; x < std::min(left + block_side, expected_.width); ++x) {
                if (expected_.is_edge[expected_.index(x, y)]) continue;
                sum += off(x, y, channel);
                rounded += std::max(0, blends(x, y) - 1);
                ++count;
            }
        return count < min_counted ? 0 : (std::abs(sum) - rounded) / count;
    }

    const Picture& drawn_;            // outlives this
    const ReferenceImage& expected_;  // outlives this
    Deviation found_;
};

}  // namespace

double Deviation::worst() const {
    return std::max({grey, colour, at_edges, blocks});
}

Deviation deviation(const Picture& drawn, const ReferenceImage& expected, bool is_noise) {
    Search search(drawn, expected);
    search.look_at_blocks();
    if (!is_noise) search.look_at_pixels();
    return search.found();
}

Deviation ComparedFrames::compare(std::uint64_t seed, int max_side) {
    const RandomFrame made = random_frame(seed, max_side);
    OffscreenScreen screen({.width = made.width, .height = made.height}, egl_);
    ReferenceCompositor reference(made.width, made.height, made.view);
    renderer_.aim(made.width, made.height, made.view);
    for (const auto& [source, picture] : made.pictures) {
        for (int upload = 0; upload < (picture.is_film ? 2 : 1); ++upload)
            renderer_.upload(source, picture.still.sample);
        reference.add(source, picture.still.sample, picture.is_film);
    }
    screen.begin_frame();
    renderer_.draw(made.frame);
    screen.present(made.frame.time);
    drawn_ = screen.picture();
    for (const auto& [source, picture] : made.pictures)
        renderer_.forget(source);
    expected_ = reference.drawn(made.frame);
    return deviation(drawn_, expected_, made.is_noise);
}

}  // namespace vitrine::player
