#include "analyzer/network/pointwise_convolution.hpp"

#include "analyzer/network/vectors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace vitrine::analyzer {
namespace {

constexpr int group = 4;   // outputs that are computed together, with 3 vectors each
constexpr int strip = 24;  // px that are computed together

/// One convolution, as the kernel gets it.
struct Task {
    int inputs = 0;
    int outputs = 0;
    std::size_t pixels = 0;  // of a plane
    const float* planes = nullptr;
    const float* weights = nullptr;
    const float* biases = nullptr;
    Activation activation = Activation::none;
    float* result = nullptr;
};

/// Computes 3 vectors of pixels of one group of outputs.
template <int lanes>
VITRINE_KERNEL void multiply_vectors(const Task& task, int first, const float* planes, float* to) {
    Vector<lanes> sums[group][3];
    for (int k = 0; k < group; ++k)
        for (Vector<lanes>& sum : sums[k])
            sum = task.biases[first + k] + Vector<lanes>{};
    const float* weights = task.weights + product(first, task.inputs);
    for (int c = 0; c < task.inputs; ++c) {
        const float* plane = planes + static_cast<std::size_t>(c) * task.pixels;
        Vector<lanes> px[3];
        for (int v = 0; v < 3; ++v)
            load<lanes>(px[v], plane + product(v, lanes));
        for (int k = 0; k < group; ++k)
            for (int v = 0; v < 3; ++v)
                sums[k][v] += weights[c * group + k] * px[v];
    }
    for (int k = 0; k < group; ++k)
        for (int v = 0; v < 3; ++v) {
            activate<lanes>(sums[k][v], task.activation);
            store<lanes>(to + product(k, strip) + product(v, lanes), sums[k][v]);
        }
}

struct Pointwise {
    template <int lanes> VITRINE_KERNEL static void run(const Task& task) {
        std::array<float, product(group, strip)> values;
        for (std::size_t at = 0; at < task.pixels; at += strip) {
            // The last strip may overlap another one.
            const std::size_t from = std::min(at, task.pixels - strip);
            for (int first = 0; first < task.outputs; first += group) {
                for (int px = 0; px < strip; px += 3 * lanes)
                    multiply_vectors<lanes>(task, first, task.planes + from + px, values.data() + px);
                for (int k = 0; k < std::min(group, task.outputs - first); ++k)
                    std::copy_n(values.data() + product(k, strip), strip,
                                task.result + static_cast<std::size_t>(first + k) * task.pixels + from);
            }
        }
    }
};

/// Computes planes that are smaller than a strip, with zeros behind them.
void multiply_small(const Task& task) {
    std::vector<float> planes(product(task.inputs, strip));
    std::vector<float> result(product(task.outputs, strip));
    for (int c = 0; c < task.inputs; ++c)
        std::copy_n(task.planes + static_cast<std::size_t>(c) * task.pixels, task.pixels,
                    planes.data() + product(c, strip));
    Task padded = task;
    padded.pixels = strip;
    padded.planes = planes.data();
    padded.result = result.data();
    run_kernel<Pointwise>(padded);
    for (int k = 0; k < task.outputs; ++k)
        std::copy_n(result.data() + product(k, strip), task.pixels,
                    task.result + static_cast<std::size_t>(k) * task.pixels);
}

}  // namespace

PointwiseConvolution::PointwiseConvolution(std::span<const float> weights, std::span<const float> biases)
    : inputs_(static_cast<int>(weights.size() / biases.size())),
      outputs_(static_cast<int>(biases.size())),
      biases_(biases.begin(), biases.end()) {
    const int padded = (outputs_ + group - 1) / group * group;
    biases_.resize(product(padded, 1));
    weights_.resize(product(padded, inputs_));
    for (int i = 0; i < outputs_ * inputs_; ++i) {
        const int output = i / inputs_;
        weights_[product(output / group * group, inputs_) + product(i % inputs_, group) +
                 product(output % group, 1)] = weights[product(i, 1)];
    }
}

void PointwiseConvolution::run(const float* planes, PlaneSize size, Activation activation,
                               float* result) const {
    const Task task{.inputs = inputs_,
                    .outputs = outputs_,
                    .pixels = product(size.height, size.width),
                    .planes = planes,
                    .weights = weights_.data(),
                    .biases = biases_.data(),
                    .activation = activation,
                    .result = result};
    if (task.pixels < strip)
        multiply_small(task);
    else
        run_kernel<Pointwise>(task);
}

}  // namespace vitrine::analyzer
