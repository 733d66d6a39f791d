#include "analyzer/network/depthwise_convolution.hpp"
#include "analyzer/network/pointwise_convolution.hpp"
#include "analyzer/network/vectors.hpp"
#include "analyzer/network/winograd_convolution.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

namespace vitrine::analyzer {
namespace {

using Values = std::vector<float>;

std::size_t index(int plane, int y, int x, PlaneSize size) {
    return (static_cast<std::size_t>(plane) * static_cast<std::size_t>(size.height) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(x);
}

Values drawn(std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<float> any(-1, 1);
    Values values(count);
    for (float& value : values)
        value = any(random);
    return values;
}

float activated(double value, Activation activation) {
    if (activation == Activation::rectified) value = std::max(0.0, value);
    if (activation == Activation::hard_swish) value *= std::clamp(value / 6 + 0.5, 0.0, 1.0);
    return static_cast<float>(value);
}

/// Weights of one output and one input, and both.
struct Pair {
    std::span<const float> weights;
    int side = 1;
    int input = 0;
};

double sum_at(const Values& planes, PlaneSize size, const Pair& pair, int y, int x) {
    double sum = 0;
    for (int i = 0; i < pair.side * pair.side; ++i) {
        const int from_y = y + i / pair.side - pair.side / 2;
        const int from_x = x + i % pair.side - pair.side / 2;
        if (from_y < 0 || from_y >= size.height || from_x < 0 || from_x >= size.width) continue;
        sum += static_cast<double>(pair.weights[static_cast<std::size_t>(i)]) *
               static_cast<double>(planes[index(pair.input, from_y, from_x, size)]);
    }
    return sum;
}

struct Case {
    int inputs = 1;
    int outputs = 1;
    int side = 1;
    bool is_depthwise = false;
    PlaneSize size;
    Activation activation = Activation::none;
};

/// By its definition, in double precision.
Values plainly(const Case& one, const Values& weights, const Values& biases, const Values& planes) {
    Values result(index(one.outputs, 0, 0, one.size));
    const auto square = static_cast<std::size_t>(one.side * one.side);
    const int inputs = one.is_depthwise ? 1 : one.inputs;
    for (int k = 0; k < one.outputs; ++k)
        for (int y = 0; y < one.size.height; ++y)
            for (int x = 0; x < one.size.width; ++x) {
                double sum = static_cast<double>(biases[static_cast<std::size_t>(k)]);
                for (int c = 0; c < inputs; ++c) {
                    const std::size_t at = static_cast<std::size_t>(k * inputs + c) * square;
                    const Pair pair{std::span(weights).subspan(at, square), one.side,
                                    one.is_depthwise ? k : c};
                    sum += sum_at(planes, one.size, pair, y, x);
                }
                result[index(k, y, x, one.size)] = activated(sum, one.activation);
            }
    return result;
}

Values run(const Convolution& convolution, const Case& one, const Values& planes) {
    Values result(index(one.outputs, 0, 0, one.size), -99);
    convolution.run(planes.data(), one.size, one.activation, result.data());
    return result;
}

float largest_difference(const Values& a, const Values& b) {
    float most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Each case with wide vectors and without, whatever the processor has.
template <typename Kind> void check(Case one, float tolerance) {
    std::mt19937 random(7);
    const auto square = static_cast<std::size_t>(one.side * one.side);
    const auto pairs = static_cast<std::size_t>(one.outputs * (one.is_depthwise ? 1 : one.inputs));
    const Values weights = drawn(pairs * square, random);
    const Values biases = drawn(static_cast<std::size_t>(one.outputs), random);
    const Values planes = drawn(index(one.inputs, 0, 0, one.size), random);
    const Kind convolution(weights, biases);
    for (const Activation activation : {Activation::none, Activation::rectified, Activation::hard_swish}) {
        one.activation = activation;
        CAPTURE(one.inputs);
        CAPTURE(one.outputs);
        CAPTURE(one.size.width);
        CAPTURE(one.size.height);
        const Values wanted = plainly(one, weights, biases, planes);
        CHECK(largest_difference(run(convolution, one, planes), wanted) < tolerance);
        turn_wide_vectors(false);
        CHECK(largest_difference(run(convolution, one, planes), wanted) < tolerance);
        turn_wide_vectors(true);
    }
}

}  // namespace

TEST_CASE("convolutions by Winograd give what plain ones give, for planes of any size") {
    const std::vector<PlaneSize> sizes{{1, 1}, {2, 3}, {4, 4}, {5, 9}, {7, 33}, {12, 40}, {9, 97}, {6, 201}};
    for (const PlaneSize size : sizes) {
        check<WinogradConvolution>({.inputs = 5, .outputs = 6, .side = 3, .size = size}, 2e-4F);
        check<WinogradConvolution>({.inputs = 1, .outputs = 1, .side = 3, .size = size}, 2e-4F);
    }
    check<WinogradConvolution>({.inputs = 24, .outputs = 17, .side = 3, .size = {13, 50}}, 5e-4F);
}

TEST_CASE("pointwise convolutions give what plain ones give, for planes of any size") {
    for (const PlaneSize size :
         std::vector<PlaneSize>{{1, 1}, {2, 3}, {1, 23}, {4, 6}, {5, 5}, {7, 33}, {12, 40}}) {
        check<PointwiseConvolution>({.inputs = 5, .outputs = 6, .size = size}, 1e-5F);
        check<PointwiseConvolution>({.inputs = 1, .outputs = 1, .size = size}, 1e-5F);
    }
    check<PointwiseConvolution>({.inputs = 48, .outputs = 31, .size = {9, 21}}, 5e-5F);
}

TEST_CASE("depthwise convolutions give what plain ones give, for planes of any size") {
    for (const int side : {3, 5})
        for (const PlaneSize size : std::vector<PlaneSize>{{1, 1}, {2, 3}, {5, 8}, {7, 33}, {12, 40}})
            check<DepthwiseConvolution>(
                {.inputs = 5, .outputs = 5, .side = side, .is_depthwise = true, .size = size}, 1e-5F);
}

}  // namespace vitrine::analyzer
