#pragma once

#include "analyzer/tapestry/synthesis/islands.hpp"
#include "base/state/tapestry.hpp"
#include "base/state/zoom_field.hpp"

#include <opencv2/core.hpp>

#include <vector>

namespace vitrine::analyzer {

/// The flow from a level to the next finer one and back: the place of each point of one level in the other.
/// Islands, which both levels show, move at a constant speed each; the parts between them are stretched, or
/// come out of the seams between islands. Both levels drawn along the flow, the finer one over the coarser
/// one, make the continuous zoom: it is coherent in time, and shows each level itself at its end.
///
/// If p of the coarser strip and q of the finer one are the same point, then p is at most a brick's width
/// from the place of q's time in the coarser strip. This tells which tiles a view needs.
///
/// Source: Video Tapestries 4.3. Differs: between the islands no picture is synthesised; a flow is computed
/// instead, so that any moment can be drawn at once.
class ZoomFlow {
  public:
    /// A part of both strips that is matched at once, px.
    struct Part {
        cv::Range coarse;
        cv::Range fine;
        cv::Range used;  // columns of the coarser strip that no other part uses
    };

    /// @param tapestry  outlives this; its tiles' width is a multiple of ZoomField::step
    /// @param finer     the finer level, >= 1
    ZoomFlow(const Tapestry& tapestry, std::size_t finer);

    /// All parts, from left to right.
    std::vector<Part> parts() const;

    /// Finds the islands of a part, and enters their motion into the flow.
    /// @param coarse, fine  CV_8UC3, the part's columns of both strips
    /// @return              islands; their places count from the part's begin
    Islands match(const Part& part, const cv::Mat& coarse, const cv::Mat& fine,
                  const RunTasks& run = run_in_order);

    /// Fills the flow between the islands. Call once all parts have been matched.
    void fill();

    /// The field of one tile. @pre fill() has been called
    /// @param is_to_finer  true: the tile is of the coarser level; else of the finer one
    ZoomField field(int tile, bool is_to_finer) const;

    /// The share of the coarser strip that islands cover, [0, 1].
    double matched() const;

  private:
    struct Point {
        Vec2 way;         // motion to the other level, px
        int samples = 0;  // number of samples in the mean; 0: unknown
    };

    /// One level and its points, which are those of all its zoom fields.
    struct Grid {
        std::size_t level = 0;
        int width = 0;        // px of the strip
        int other_width = 0;  // px of the other level's strip
        int columns = 0;
        std::vector<Point> points;
        std::vector<Vec2> places;

        double x(int column) const;
        std::size_t number(int column, int row) const;
    };

    struct Sample;

    Grid grid(std::size_t level, std::size_t other) const;
    cv::Point to_fine(cv::Point at) const;
    cv::Point to_coarse(cv::Point at) const;
    int brick_at(cv::Point at, int keyframes) const;
    void add(Grid& grid, std::vector<Sample> samples) const;
    void fill(Grid& grid) const;
    void spread(Grid& grid) const;
    void smooth(Grid& grid) const;
    void put_in_order(Grid& grid) const;
    cv::Vec2d bounds(const Grid& grid, double x) const;

    const Tapestry& tapestry_;
    std::size_t finer_;
    std::vector<int> kept_;  // one a coarser keyframe: its number in the finer level
    std::vector<int> from_;  // one a finer keyframe: its number in the coarser level, or -1
    Grid coarse_;
    Grid fine_;
};

}  // namespace vitrine::analyzer
