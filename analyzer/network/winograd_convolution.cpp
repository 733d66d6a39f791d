#include "analyzer/network/winograd_convolution.hpp"

#include "analyzer/network/vectors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace vitrine::analyzer {
namespace {

constexpr int tile = 4;                // px, side of a part of the result that is computed as one
constexpr int patch = 6;               // px, side of the part of a plane on which a tile depends
constexpr int values = patch * patch;  // of a patch
constexpr int block = 48;              // tiles of a row that are computed together
constexpr int group = 4;               // outputs that are multiplied together, with at most 3 vectors each

/// One convolution, as the kernel gets it.
struct Task {
    int inputs = 0;
    int outputs = 0;
    int height = 0;  // px
    int width = 0;   // px
    const float* planes = nullptr;
    const float* weights = nullptr;
    const float* biases = nullptr;
    Activation activation = Activation::none;
    float* result = nullptr;
};

int groups_of(int outputs) {
    return (outputs + group - 1) / group;
}

/// The intermediate values of a row of tiles.
struct Work {
    explicit Work(const Task& task)
        : stride((task.width + tile - 1) / tile + block),
          line(std::make_unique_for_overwrite<float[]>(product(stride, tile))),
          rows(std::make_unique_for_overwrite<float[]>(product(task.inputs, patch * tile, stride))),
          patches(std::make_unique_for_overwrite<float[]>(product(values, task.inputs, block))),
          products(std::make_unique_for_overwrite<float[]>(
              product(values, groups_of(task.outputs) * group, block))) {}

    int stride;                         // tiles of a row, with room for a block
    std::unique_ptr<float[]> line;      // px, from the border on
    std::unique_ptr<float[]> rows;      // inputs x 6 rows x 4 columns of a tile x tiles
    std::unique_ptr<float[]> patches;   // transformed: 36 x inputs x tiles of a block
    std::unique_ptr<float[]> products;  // 36 x outputs of all groups x tiles of a block
};

/// A block of tiles.
struct Block {
    int row = 0;
    int first = 0;  // tile of the row
    int tiles = 0;
};

/// Reads the six rows of px for a row of tiles, with zeros around the planes. Each fourth px come together.
VITRINE_KERNEL void read_rows(const Task& task, int row, Work& work) {
    const int padded = work.stride * tile;
    for (int i = 0; i < task.inputs * patch; ++i) {
        float* to = work.rows.get() + product(i, tile, work.stride);
        const int y = row * tile + i % patch - 1;
        if (y < 0 || y >= task.height) {
            std::fill(to, to + padded, 0.F);
            continue;
        }
        float* line = work.line.get();
        const float* from =
            task.planes + product(i / patch, task.height, task.width) + product(y, task.width);
        line[0] = 0;
        std::copy(from, from + task.width, line + 1);
        std::fill(line + 1 + task.width, line + padded, 0.F);
        for (int t = 0; t < work.stride; ++t)
            for (int x = 0; x < tile; ++x)
                to[x * work.stride + t] = line[tile * t + x];
    }
}

/// B^T d of the paper, for six values at a distance in memory.
template <int lanes>
VITRINE_KERNEL void transform_patch(const Vector<lanes>* d, Vector<lanes>* to, std::ptrdiff_t step) {
    const Vector<lanes> a = d[4 * step] - 4.F * d[2 * step];
    const Vector<lanes> b = d[3 * step] - 4.F * d[step];
    const Vector<lanes> c = d[4 * step] - d[2 * step];
    const Vector<lanes> e = 2.F * (d[3 * step] - d[step]);
    const Vector<lanes> first = 4.F * d[0] - 5.F * d[2 * step] + d[4 * step];
    const Vector<lanes> last = 4.F * d[step] - 5.F * d[3 * step] + d[5 * step];
    to[0] = first;
    to[step] = a + b;
    to[2 * step] = a - b;
    to[3 * step] = c + e;
    to[4 * step] = c - e;
    to[5 * step] = last;
}

template <int lanes> VITRINE_KERNEL void transform_patches(const Task& task, const Block& at, Work& work) {
    for (int c = 0; c < task.inputs; ++c) {
        const float* rows = work.rows.get() + product(c, patch * tile, work.stride) + at.first;
        for (int t = 0; t < at.tiles; t += lanes) {
            Vector<lanes> d[values];
            for (int y = 0; y < patch; ++y)
                for (int x = 0; x < patch; ++x)
                    load<lanes>(d[y * patch + x],
                                rows + product(y * tile + x % tile, work.stride) + x / tile + t);
            for (int x = 0; x < patch; ++x)
                transform_patch<lanes>(d + x, d + x, patch);
            for (int y = 0; y < patch; ++y)
                transform_patch<lanes>(d + product(y, patch), d + product(y, patch), 1);
            for (int i = 0; i < values; ++i)
                store<lanes>(work.patches.get() + product(i, task.inputs, block) + product(c, block) + t,
                             d[i]);
        }
    }
}

/// Products of one group of outputs for `count` vectors of tiles.
template <int lanes, int count>
VITRINE_KERNEL void multiply(const float* weights, const float* patches, int inputs, float* to) {
    Vector<lanes> sums[group][count] = {};
    for (int c = 0; c < inputs; ++c) {
        Vector<lanes> tiles[count];
        for (int v = 0; v < count; ++v)
            load<lanes>(tiles[v], patches + product(c, block) + product(v, lanes));
        for (int k = 0; k < group; ++k)
            for (int v = 0; v < count; ++v)
                sums[k][v] += weights[c * group + k] * tiles[v];
    }
    for (int k = 0; k < group; ++k)
        for (int v = 0; v < count; ++v)
            store<lanes>(to + product(k, block) + product(v, lanes), sums[k][v]);
}

template <int lanes> VITRINE_KERNEL void multiply_all(const Task& task, const Block& at, Work& work) {
    const int groups = groups_of(task.outputs);
    for (int i = 0; i < values * groups; ++i) {
        const float* weights = task.weights + product(i, task.inputs, group);
        const float* patches = work.patches.get() + product(i / groups, task.inputs, block);
        float* to = work.products.get() + product(i, group, block);
        int t = 0;
        for (; t + 2 * lanes < at.tiles; t += 3 * lanes)
            multiply<lanes, 3>(weights, patches + t, task.inputs, to + t);
        if (t + lanes < at.tiles)
            multiply<lanes, 2>(weights, patches + t, task.inputs, to + t);
        else if (t < at.tiles)
            multiply<lanes, 1>(weights, patches + t, task.inputs, to + t);
    }
}

/// A^T m of the paper, for six values at a distance in memory.
template <int lanes>
VITRINE_KERNEL void transform_products(const Vector<lanes>* m, Vector<lanes>* to, std::ptrdiff_t step) {
    const Vector<lanes> a = m[step] + m[2 * step];
    const Vector<lanes> b = m[step] - m[2 * step];
    const Vector<lanes> c = m[3 * step] + m[4 * step];
    const Vector<lanes> d = m[3 * step] - m[4 * step];
    const Vector<lanes> first = m[0] + a + c;
    const Vector<lanes> last = b + 8.F * d + m[5 * step];
    to[0] = first;
    to[step] = b + 2.F * d;
    to[2 * step] = a + 4.F * c;
    to[3 * step] = last;
}

/// Writes the tiles of one output.
template <int lanes>
VITRINE_KERNEL void write_tiles(const Task& task, const Block& at, int output, const Work& work) {
    const float* products = work.products.get() + product(output, block);
    const std::size_t plane = product(groups_of(task.outputs) * group, block);
    float columns[tile * tile][block];  // px of tiles: 4 x 4, for each tile
    for (int t = 0; t < at.tiles; t += lanes) {
        Vector<lanes> m[values];
        for (int i = 0; i < values; ++i)
            load<lanes>(m[i], products + static_cast<std::size_t>(i) * plane + t);
        for (int x = 0; x < patch; ++x)
            transform_products<lanes>(m + x, m + x, patch);
        for (int y = 0; y < tile; ++y) {
            transform_products<lanes>(m + product(y, patch), m + product(y, patch), 1);
            for (int x = 0; x < tile; ++x) {
                Vector<lanes> value = m[y * patch + x] + task.biases[output];
                activate<lanes>(value, task.activation);
                store<lanes>(columns[y * tile + x] + t, value);
            }
        }
    }
    const int width = std::min(tile * at.tiles, task.width - tile * at.first);
    float line[tile * block];
    for (int y = 0; y < tile && at.row * tile + y < task.height; ++y) {
        for (int t = 0; t < at.tiles; ++t)
            for (int x = 0; x < tile; ++x)
                line[t * tile + x] = columns[y * tile + x][t];
        std::copy(line, line + width,
                  task.result + product(output, task.height, task.width) +
                      product(at.row * tile + y, task.width) + product(tile, at.first));
    }
}

struct Winograd {
    template <int lanes> VITRINE_KERNEL static void run(const Task& task) {
        Work work(task);
        const int across = (task.width + tile - 1) / tile;
        for (int row = 0; row * tile < task.height; ++row) {
            read_rows(task, row, work);
            for (int first = 0; first < across; first += block) {
                const Block at{row, first, std::min(block, across - first)};
                transform_patches<lanes>(task, at, work);
                multiply_all<lanes>(task, at, work);
                for (int output = 0; output < task.outputs; ++output)
                    write_tiles<lanes>(task, at, output, work);
            }
        }
    }
};

/// G g G^T of the paper.
std::array<float, values> transformed(const float* weights) {
    constexpr std::array<std::array<float, 3>, patch> g{{{1.F / 4, 0, 0},
                                                         {-1.F / 6, -1.F / 6, -1.F / 6},
                                                         {-1.F / 6, 1.F / 6, -1.F / 6},
                                                         {1.F / 24, 1.F / 12, 1.F / 6},
                                                         {1.F / 24, -1.F / 12, 1.F / 6},
                                                         {0, 0, 1}}};
    std::array<float, values> result{};
    for (std::size_t i = 0; i < values; ++i)
        for (std::size_t y = 0; y < 3; ++y)
            for (std::size_t x = 0; x < 3; ++x)
                result[i] += g[i / patch][y] * weights[3 * y + x] * g[i % patch][x];
    return result;
}

}  // namespace

WinogradConvolution::WinogradConvolution(std::span<const float> weights, std::span<const float> biases)
    : inputs_(static_cast<int>(weights.size() / (9 * biases.size()))),
      outputs_(static_cast<int>(biases.size())),
      biases_(biases.begin(), biases.end()) {
    const int groups = groups_of(outputs_);
    weights_.resize(product(values, groups * group, inputs_));
    for (int i = 0; i < outputs_ * inputs_; ++i) {
        const int output = i / inputs_;
        const std::array<float, values> at = transformed(weights.data() + product(i, 9, 1));
        for (int v = 0; v < values; ++v)
            weights_[product(v * groups + output / group, inputs_, group) + product(i % inputs_, group) +
                     static_cast<std::size_t>(output % group)] = at[static_cast<std::size_t>(v)];
    }
}

void WinogradConvolution::run(const float* planes, PlaneSize size, Activation activation,
                              float* result) const {
    const Task task{inputs_,         outputs_,       size.height, size.width, planes,
                    weights_.data(), biases_.data(), activation,  result};
    run_kernel<Winograd>(task);
}

}  // namespace vitrine::analyzer
