#pragma once

#include "player/playback/sample.hpp"
#include "player/scene/frame.hpp"

#include <array>
#include <vector>

namespace vitrine::player {

using Rgb = std::array<double, 3>;  // in [0, 1]

/// A picture with its smaller copies, sampled by plain code in double precision.
class ReferencePicture {
  public:
    /// @param is_film  the picture follows another one of its source
    ReferencePicture(const Sample& sample, bool is_film);

    /// Notes that the filler needs smaller copies; from then on small pictures are drawn from them.
    void make_smaller_copies() { has_smaller_copies_ = true; }

    /// Prepares for an item, as the renderer chooses its sampling. @param px  pixels of the screen a canvas
    /// px
    void aim(const DrawItem& item, Vec2 px, bool is_on_pixels);

    /// True if each texel is drawn as one pixel.
    bool is_exact() const { return is_exact_; }

    int width() const { return width_; }

    int height() const { return height_; }

    /// Sample::slide.
    Vec2 slide() const { return slide_; }

    /// The colour at a place, as shares of the picture's width and height.
    Rgb at(Vec2 place) const;

    /// The blurred colour of the filler at a place; the picture is mirrored at its edges or its bars.
    /// @param active  DrawItem::active, as shares of the picture's width and height
    /// @param light   DrawItem::filler_light
    Rgb filler_at(Vec2 place, const Box& active, double light) const;

  private:
    /// A plane in one size; its values are in [0, 1].
    struct Level {
        int width = 0;
        int height = 0;
        std::vector<double> values;

        double texel(int x, int y) const;
        double at(Vec2 place) const;
    };

    using Channel = std::vector<Level>;  // the picture's own size first, each next one half as large

    static Channel smaller_copies(Level whole);
    double sampled(const Channel& channel, Vec2 place, double level) const;
    Rgb colour_of(const std::array<double, 3>& coded) const;
    void add_channel(const Sample::Plane& plane, int width, int height, std::array<std::size_t, 2> bytes);

    int width_;
    int height_;
    Vec2 slide_;
    bool is_rgb_;
    bool is_film_;
    ColourCode code_;
    std::array<Channel, 3> channels_;
    std::size_t count_ = 0;  // channels that were added
    bool has_smaller_copies_ = false;
    bool is_exact_ = false;
    std::array<double, 3> levels_{};  // the smaller copy that each channel is read from
};

}  // namespace vitrine::player
