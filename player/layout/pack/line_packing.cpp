#include "player/layout/pack/line_packing.hpp"

#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <algorithm>
#include <limits>

namespace vitrine::player {

namespace {

constexpr double gap = 2 * ReadingOrder::margin;  // px between boxes, and between centroids of a line

/// Puts one shape beside another until the line has its full width, then starts the next line.
class LinePacking {
  public:
    LinePacking(const ScaledShapes& shapes, double width)
        : shapes_(shapes), width_(width), places_(shapes.size()) {
        double height = 0;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            height += shapes.shapes[i].extent.height() * shapes.scales[i];
        half_line_ = height / (2 * static_cast<double>(shapes.size()));
        for (std::size_t i = 0; i < shapes.size(); ++i)
            add(i);
        end_line(shapes.size());
    }

    const std::vector<Vec2>& places() const { return places_; }

  private:
    void add(std::size_t item) {
        const Box box = shapes_.extent(item);
        if (item > begin_ && right_ + box.width() > width_) end_line(item);
        places_[item].x = right_ - box.min.x;
        right_ += box.width() + gap;
        above_ = std::max(above_, -box.min.y);
        below_ = std::max(below_, box.max.y);
    }

    /// Moves the line down until it is clear of the line above, and at least half a line below it.
    void end_line(std::size_t end) {
        const double y = begin_ == 0 ? 0 : std::max(bottom_ + above_ + gap, y_ + half_line_ + gap);
        for (std::size_t i = begin_; i < end; ++i)
            places_[i].y = y;
        y_ = y;
        bottom_ = y + below_;
        begin_ = end;
        right_ = above_ = below_ = 0;
    }

    ScaledShapes shapes_;  // outlive this
    double width_;         // px; limit of a line's width
    std::vector<Vec2> places_;
    double half_line_ = 0;
    std::size_t begin_ = 0;         // first item of the line
    double right_ = 0;              // right end of the line so far
    double above_ = 0, below_ = 0;  // reach of the line's items above and below their centroids
    double y_ = 0, bottom_ = 0;     // centroids and lower edge of the previous line
};

}  // namespace

std::vector<Vec2> packed_in_lines(const ScaledShapes& shapes, double ratio) {
    double whole = 0;
    double widest = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const double item_width = shapes.shapes[i].extent.width() * shapes.scales[i];
        whole += item_width + gap;
        widest = std::max(widest, item_width);
    }
    std::vector<Vec2> best(shapes.size());
    double smallest = std::numeric_limits<double>::infinity();
    for (const double slack : {1.0, 1.1, 1.2, 1.35})
        for (std::size_t lines = 1; lines <= shapes.size(); ++lines) {
            const double width = std::max(widest, whole / static_cast<double>(lines) * slack);
            const LinePacking packing(shapes, width);
            const double screen = screen_area(bounds_of(shapes, packing.places()), ratio);
            if (screen >= smallest) continue;
            smallest = screen;
            best = packing.places();
        }
    return best;
}

}  // namespace vitrine::player
