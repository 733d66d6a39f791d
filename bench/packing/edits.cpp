#include "bench/packing/bench.hpp"
#include "tests/player/layout/random_edits.hpp"

#include <fmt/format.h>

namespace vitrine::player {

void print_edits(std::int64_t count) {
    constexpr std::int64_t edits_a_wall = 1000;
    std::int64_t done = 0;
    std::int64_t wrong = 0;
    const double start = cpu_ms();
    for (std::uint64_t seed = 1; done < count; ++seed) {
        RandomEdits edits(seed);
        for (std::int64_t k = 0; k < edits_a_wall && done < count; ++k, ++done)
            if (const auto fault = edits.step()) {
                if (wrong++ < 10) fmt::print("seed {}, edit {}: {}\n", seed, k, *fault);
            }
    }
    fmt::print(
        "\n{} random edits: {} layouts with an overlap or a region beyond the canvas; {:.3f} ms each\n", done,
        wrong, (cpu_ms() - start) / static_cast<double>(done));
}

}  // namespace vitrine::player
