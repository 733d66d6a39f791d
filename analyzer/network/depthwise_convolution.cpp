#include "analyzer/network/depthwise_convolution.hpp"

#include "analyzer/network/vectors.hpp"

#include <algorithm>
#include <cstddef>

namespace vitrine::analyzer {
namespace {

/// All planes, as the kernel gets them.
struct Task {
    PlaneSize size;
    int side = 3;  // px, of the weights: 3 or 5
    std::span<const float> biases;
    const float* planes = nullptr;
    const float* weights = nullptr;
    Activation activation = Activation::none;
    float* result = nullptr;
};

/// The rows of a plane that one row of the result depends on, each with a border of zeros. They take turns:
/// row y is in place y modulo the side.
struct Rows {
    explicit Rows(const Task& task)
        : border(task.side / 2),
          stride(task.size.width + 2 * border + max_lanes),
          values(product(task.side, stride)),
          result(product(task.size.width + max_lanes, 1)) {}

    float* row(int y, int side) { return values.data() + product((y + border) % side, stride); }

    int border;  // px
    int stride;  // px of a row, with room for a vector
    std::vector<float> values;
    std::vector<float> result;  // one row
};

VITRINE_KERNEL void read_row(const Task& task, const float* plane, int y, Rows& rows) {
    float* to = rows.row(y, task.side) + rows.border;
    if (y < task.size.height)
        std::copy_n(plane + product(y, task.size.width), task.size.width, to);
    else
        std::fill_n(to, task.size.width, 0.F);
}

template <int lanes, int side>
VITRINE_KERNEL void convolve_row(const Task& task, int plane, int y, Rows& rows) {
    const float* from[side];
    for (int i = 0; i < side; ++i)
        from[i] = rows.row(y + i - rows.border, side);
    const float* weights = task.weights + product(plane, side * side);
    for (int x = 0; x < task.size.width; x += lanes) {
        Vector<lanes> sum = task.biases[static_cast<std::size_t>(plane)] + Vector<lanes>{};
        for (int i = 0; i < side * side; ++i) {
            Vector<lanes> px;
            load<lanes>(px, from[i / side] + x + i % side);
            sum += weights[i] * px;
        }
        activate<lanes>(sum, task.activation);
        store<lanes>(rows.result.data() + x, sum);
    }
}

template <int lanes, int side> VITRINE_KERNEL void convolve_planes(const Task& task) {
    Rows rows(task);
    const std::size_t pixels = product(task.size.height, task.size.width);
    for (int plane = 0; plane < static_cast<int>(task.biases.size()); ++plane) {
        const float* from = task.planes + static_cast<std::size_t>(plane) * pixels;
        float* to = task.result + static_cast<std::size_t>(plane) * pixels;
        std::ranges::fill(rows.values, 0.F);
        for (int y = 0; y < rows.border; ++y)
            read_row(task, from, y, rows);
        for (int y = 0; y < task.size.height; ++y) {
            read_row(task, from, y + rows.border, rows);
            convolve_row<lanes, side>(task, plane, y, rows);
            std::copy_n(rows.result.data(), task.size.width, to + product(y, task.size.width));
        }
    }
}

struct Depthwise {
    template <int lanes> VITRINE_KERNEL static void run(const Task& task) {
        if (task.side == 3)
            convolve_planes<lanes, 3>(task);
        else
            convolve_planes<lanes, 5>(task);
    }
};

}  // namespace

DepthwiseConvolution::DepthwiseConvolution(std::span<const float> weights, std::span<const float> biases)
    : side_(weights.size() == 9 * biases.size() ? 3 : 5),
      weights_(weights.begin(), weights.end()),
      biases_(biases.begin(), biases.end()) {}

void DepthwiseConvolution::run(const float* planes, PlaneSize size, Activation activation,
                               float* result) const {
    run_kernel<Depthwise>(Task{.size = size,
                               .side = side_,
                               .biases = biases_,
                               .planes = planes,
                               .weights = weights_.data(),
                               .activation = activation,
                               .result = result});
}

}  // namespace vitrine::analyzer
