// Measures density, time and calm of the packing of I-Regions: the paper's way and ours, on the same
// instances.
//   packing [--only TABLE] [--instances N] [--edits N] [--catalogue DIRECTORY]
// Tables: shares, real, paper, moves, many, changes, edits, bands, turns. Shares are of a 16:9 screen, times
// are of the CPU.

#include "bench/packing/bench.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

using namespace vitrine;
using namespace vitrine::player;

namespace {

BenchOptions options_of(int argc, char** argv) {
    BenchOptions options;
    for (int k = 1; k + 1 < argc; k += 2) {
        const std::string_view name = argv[k];
        if (name == "--only") options.only = argv[k + 1];
        if (name == "--instances") options.instances = std::atoi(argv[k + 1]);
        if (name == "--edits") options.edits = std::atoll(argv[k + 1]);
        if (name == "--catalogue") options.catalogue = argv[k + 1];
    }
    return options;
}

void print_real(const BenchOptions& options) {
    const Items all = regions_of(options.catalogue);
    if (all.empty()) {
        fmt::print("\nno regions in '{}'\n", options.catalogue);
        return;
    }
    const auto drawn = [&](std::size_t count, Random& random) {
        Items items;
        for (std::size_t i = 0; i < count; ++i)
            items.push_back(all[uniform_index(random, all.size())]);
        return items;
    };
    print_shares(fmt::format("{} regions of the catalogue", all.size()).c_str(), drawn, options.instances,
                 true);
}

}  // namespace

int main(int argc, char** argv) {
    const BenchOptions options = options_of(argc, argv);
    const auto wants = [&](std::string_view table) { return options.only.empty() || options.only == table; };
    if (wants("paper")) print_paper(options.instances);
    if (wants("moves")) print_moves();
    if (wants("many")) print_many();
    if (wants("changes")) print_changes(options.instances);
    if (wants("shares")) print_shares("random hulls", random_hulls, options.instances, false);
    if (wants("real") && !options.catalogue.empty()) print_real(options);
    const Items real = regions_of(options.catalogue);
    const auto drawn = [&](std::size_t count, Random& random) {
        Items items;
        for (std::size_t i = 0; i < count; ++i)
            items.push_back(real[uniform_index(random, real.size())]);
        return items;
    };
    if (wants("bands")) print_bands("random hulls", random_hulls, options.instances, false);
    if (wants("bands") && !real.empty())
        print_bands("regions of the catalogue", drawn, options.instances, true);
    if (wants("turns") && !real.empty()) print_band_turns(drawn, options.instances);
    if (wants("edits")) print_edits(options.edits);
}
