#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/initial_packing.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <algorithm>
#include <limits>

namespace vitrine::player {

namespace {

constexpr double gap = 2 * ReadingOrder::margin;  // px between boxes, and between centroids of a line

/// Puts one shape beside the other until a line is as wide as it may be, then begins the next.
class Lines {
  public:
    Lines(std::span<const Shape> shapes, std::span<const double> scales, double width)
        : shapes_(shapes), scales_(scales), width_(width), places_(shapes.size()) {
        double height = 0;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            height += shapes[i].extent.height() * scales[i];
        half_line_ = height / (2 * static_cast<double>(shapes.size()));
        for (std::size_t i = 0; i < shapes.size(); ++i)
            add(i);
        end_line(shapes.size());
    }

    const std::vector<Vec2>& places() const { return places_; }

  private:
    Box extent(std::size_t item) const {
        return {shapes_[item].extent.min * scales_[item], shapes_[item].extent.max * scales_[item]};
    }

    void add(std::size_t item) {
        const Box box = extent(item);
        if (item > begin_ && right_ + box.width() > width_) end_line(item);
        places_[item].x = right_ - box.min.x;
        right_ += box.width() + gap;
        above_ = std::max(above_, -box.min.y);
        below_ = std::max(below_, box.max.y);
    }

    /// Lowers the line until it is clear of the one above, and at least half a line below it.
    void end_line(std::size_t end) {
        const double y = begin_ == 0 ? 0 : std::max(bottom_ + above_ + gap, y_ + half_line_ + gap);
        for (std::size_t i = begin_; i < end; ++i)
            places_[i].y = y;
        y_ = y;
        bottom_ = y + below_;
        begin_ = end;
        right_ = above_ = below_ = 0;
    }

    std::span<const Shape> shapes_;
    std::span<const double> scales_;
    double width_;
    std::vector<Vec2> places_;
    double half_line_ = 0;
    std::size_t begin_ = 0;         // of the line's items
    double right_ = 0;              // end of the line so far
    double above_ = 0, below_ = 0;  // of the line's centroids
    double y_ = 0, bottom_ = 0;     // of the line before
};

}  // namespace

std::vector<Vec2> packed_in_lines(std::span<const Shape> shapes, std::span<const double> scales,
                                  double ratio) {
    double whole = 0;
    double widest = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        whole += shapes[i].extent.width() * scales[i] + gap;
        widest = std::max(widest, shapes[i].extent.width() * scales[i]);
    }
    std::vector<Vec2> best(shapes.size());
    double least = std::numeric_limits<double>::infinity();
    for (const double slack : {1.0, 1.1, 1.2, 1.35})
        for (std::size_t lines = 1; lines <= shapes.size(); ++lines) {
            const double width = std::max(widest, whole / static_cast<double>(lines) * slack);
            const Lines packing(shapes, scales, width);
            const double screen = screen_area(bounds_of(shapes, scales, packing.places()), ratio);
            if (screen >= least) continue;
            least = screen;
            best = packing.places();
        }
    return best;
}

}  // namespace vitrine::player
