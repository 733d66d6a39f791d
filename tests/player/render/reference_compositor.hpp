#pragma once

#include "player/render/view.hpp"
#include "player/scene/frame.hpp"
#include "tests/player/render/reference_picture.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace vitrine::player {

/// A picture drawn by the reference. Rows from the top.
struct ReferenceImage {
    int width = 0;  // px
    int height = 0;
    std::vector<Rgb> pixels;            // of the screen, rounded to 8 bits a channel
    std::vector<std::uint16_t> blends;  // translucent triangles that were drawn over one another
    std::vector<bool> is_edge;  // within 1.5 px of the edge of something drawn, or on a triangle's side
    std::vector<std::array<float, 3>> low;   // the least that was ever drawn on a pixel, or was there
    std::vector<std::array<float, 3>> high;  // the most

    const Rgb& at(int x, int y) const { return pixels[index(x, y)]; }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Draws frames as the renderer should, by plain code on the processor in double precision and without GL.
/// It knows of no tiles, and looks at one pixel after the other.
class ReferenceCompositor {
  public:
    /// @param width, height  the screen's size, px
    ReferenceCompositor(int width, int height, const View& view)
        : width_(width), height_(height), view_(view) {}

    void add(SourceId source, const Sample& sample, bool is_film) {
        pictures_.insert_or_assign(source, ReferencePicture(sample, is_film));
    }

    ReferenceImage drawn(const Frame& frame);

  private:
    /// A corner of a triangle on the screen.
    struct Corner {
        Vec2 at;     // px of the screen
        Vec2 place;  // share of the picture
        double opacity = 1;
        Rgb colour{};  // of the idle picture
    };

    using Triangle = std::array<Corner, 3>;
    using Shade = std::function<Rgb(const Corner& at)>;

    Vec2 on_screen(Vec2 canvas_point) const;
    void draw_idle(const Frame& frame);
    void draw_run(std::span<const DrawItem> items);
    void draw_fills(const DrawItem& item);
    void draw_fringes(const DrawItem& item);
    void draw_fringe(const DrawItem& item, const FadeEdge& edge, double coverage, const Shade& shade);
    void draw_zoom(const DrawItem& item);
    Corner corner(const DrawItem& item, Vec2 canvas_point, double opacity) const;
    Shade shade_of(const DrawItem& item, bool is_filler);
    void draw_triangle(Triangle triangle, const Shade& shade);
    void draw_row(const Triangle& triangle, int y, const Shade& shade);
    void blend(int x, int y, const Rgb& colour, double opacity);
    void mark_edge(Vec2 from, Vec2 to);
    void mark_outlines(std::span<const Polygon> outlines);

    int width_;
    int height_;
    View view_;
    std::map<SourceId, ReferencePicture> pictures_;
    const Frame* frame_ = nullptr;  // the frame that is being drawn
    bool is_on_pixels_ = false;
    ReferenceImage image_;
};

}  // namespace vitrine::player
