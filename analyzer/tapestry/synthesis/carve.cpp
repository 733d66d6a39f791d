// Retargeting that begins with a carved picture needs far fewer rounds, and ends nearer to the source, than
// one that begins with a scaled picture: almost all patches are whole from the start, and their places are
// known.

#include "analyzer/tapestry/synthesis/carve.hpp"

#include <algorithm>
#include <array>

namespace vitrine::analyzer {

namespace {

constexpr float never = 1e12F;  // costs more than any seam

std::size_t index(int value) {
    return static_cast<std::size_t>(value);
}

/// A picture stored column by column, the remaining rows next to each other.
class Carver {
  public:
    explicit Carver(const CarveInput& input)
        : columns_(input.picture.cols),
          height_(input.picture.rows),
          stride_(height_ + 2),
          loss_(index(columns_ * stride_)),
          sums_(index(columns_ * stride_), never),
          from_(index(columns_ * stride_)),
          bricks_(index(columns_ * stride_)),
          rows_(index(columns_ * stride_)),
          is_given_(index(columns_)),
          straight_(index(height_)),
          falling_(index(height_)),
          rising_(index(height_)) {
        for (std::vector<float>& colour : colours_)
            colour.resize(index(columns_ * stride_));
        for (int x = 0; x < columns_; ++x) {
            is_given_[index(x)] =
                !input.given.empty() && input.given.at<std::uint8_t>(0, x) != CarveInput::open;
            for (int y = 0; y < height_; ++y)
                put(input, x, y);
        }
    }

    int height() const { return height_; }

    void take_seam() {
        for (int x = 0; x < columns_; ++x)
            reach(x);
        const float* sums = column(sums_, columns_ - 1);
        auto y = static_cast<int>(std::min_element(sums, sums + height_) - sums);
        for (int x = columns_ - 1; x >= 0; --x) {
            const int before = from_[at(x, y)];
            take(x, y);
            y = before;
        }
        --height_;
    }

    KeptRows kept() const {
        KeptRows kept{.columns = columns_, .height = height_, .rows = {}};
        for (int x = 0; x < columns_; ++x) {
            const std::int16_t* rows = &rows_[at(x, 0)];
            kept.rows.insert(kept.rows.end(), rows, rows + height_);
        }
        return kept;
    }

  private:
    std::size_t at(int x, int y) const { return index(x * stride_ + 1 + y); }

    template <typename Value> Value* column(std::vector<Value>& values, int x) const {
        return &values[at(x, 0)];
    }

    void put(const CarveInput& input, int x, int y) {
        const auto& pixel = input.picture.at<cv::Vec3b>(y, x);
        for (int c = 0; c < 3; ++c)
            colours_[index(c)][at(x, y)] = pixel[c];
        loss_[at(x, y)] = input.loss.at<float>(y, x);
        bricks_[at(x, y)] = input.bricks.at<std::int16_t>(y, x);
        rows_[at(x, y)] = static_cast<std::int16_t>(y);
        if (!is_given_[index(x)]) return;
        loss_[at(x, y)] = input.given.at<std::uint8_t>(y, x) == CarveInput::stays ? never : 0;
    }

    /// Computes the costs of reaching each pixel of a column: along its row, from the row above, from the row
    /// below.
    void price(int x) {
        std::copy_n(column(loss_, x), height_, straight_.begin());
        std::fill_n(falling_.begin(), height_, 0.F);
        std::fill_n(rising_.begin(), height_, 0.F);
        if (is_given_[index(x)]) return;
        for (std::vector<float>& colour : colours_) {
            float* own = column(colour, x);
            own[-1] = own[0];
            own[height_] = own[height_ - 1];
            const float* before = x > 0 ? column(colour, x - 1) : own;
            for (int y = 0; y < height_; ++y) {
                const float across = own[y + 1] - own[y - 1];
                const float above = before[y] - own[y - 1];
                const float below = before[y] - own[y + 1];
                straight_[index(y)] += across * across;
                falling_[index(y)] += above * above;
                rising_[index(y)] += below * below;
            }
        }
    }

    /// Computes the cheapest seam to each pixel of a column, and the row in the column before that it comes
    /// from.
    void reach(int x) {
        price(x);
        float* sums = column(sums_, x);
        if (x == 0) {
            std::copy_n(straight_.begin(), height_, sums);
        } else {
            const float* before = column(sums_, x - 1);
            std::int16_t* from = column(from_, x);
            for (int y = 0; y < height_; ++y) {
                const float falling = falling_[index(y)] + before[y - 1];
                const float rising = rising_[index(y)] + before[y + 1];
                const float least = std::min(before[y], std::min(falling, rising));
                sums[y] = straight_[index(y)] + least;
                from[y] = static_cast<std::int16_t>(least == before[y] ? y
                                                    : least == falling ? y - 1
                                                                       : y + 1);
            }
            for (int first = 0; first < height_;)
                first = jump(x, first);
        }
        sums[height_] = never;
    }

    /// A seam may come from any row beside the same brick, where the brick changes or the rows are given.
    /// @return the row in which the next brick of the column begins
    int jump(int x, int first) {
        const bool is_given = is_given_[index(x)] != 0;
        int end = first + 1;
        while (end < height_ && (is_given || bricks_[at(x, end)] == bricks_[at(x, first)]))
            ++end;
        const int middle = (first + end) / 2;
        if (!is_given && bricks_[at(x, middle)] == bricks_[at(x - 1, middle)]) return end;
        const float* before = column(sums_, x - 1);
        const auto best = static_cast<int>(std::min_element(before + first, before + end) - before);
        for (int y = first; y < end; ++y) {
            sums_[at(x, y)] = straight_[index(y)] + before[best];
            from_[at(x, y)] = static_cast<std::int16_t>(best);
        }
        return end;
    }

    void take(int x, int y) {
        const auto close = [&](auto& values) {
            auto* from = column(values, x);
            std::copy(from + y + 1, from + height_, from + y);
        };
        for (std::vector<float>& colour : colours_)
            close(colour);
        close(loss_);
        close(bricks_);
        close(rows_);
    }

    int columns_;
    int height_;
    int stride_;  // values of a column, with one place before it and one behind
    std::array<std::vector<float>, 3> colours_;
    std::vector<float> loss_;
    std::vector<float> sums_;         // cost of the cheapest seam that ends at a pixel
    std::vector<std::int16_t> from_;  // row of that seam in the column before
    std::vector<std::int16_t> bricks_;
    std::vector<std::int16_t> rows_;
    std::vector<std::uint8_t> is_given_;
    std::vector<float> straight_;
    std::vector<float> falling_;
    std::vector<float> rising_;
};

}  // namespace

KeptRows carved(const CarveInput& input, int height) {
    Carver carver(input);
    while (carver.height() > height)
        carver.take_seam();
    return carver.kept();
}

cv::Mat picture_of(const cv::Mat& picture, const KeptRows& kept) {
    cv::Mat left(kept.height, kept.columns, CV_8UC3);
    for (int y = 0; y < kept.height; ++y)
        for (int x = 0; x < kept.columns; ++x)
            left.at<cv::Vec3b>(y, x) = picture.at<cv::Vec3b>(kept.at(x, y), x);
    return left;
}

}  // namespace vitrine::analyzer
