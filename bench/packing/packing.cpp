// Measures density, time and calm of the packing of I-Regions: the paper's way and ours, on the same
// instances.
//   packing [--only TABLE] [--instances N] [--edits N] [--catalogue DIRECTORY]
// Tables: shares, real, paper, moves, many, changes, edits, bands, turns. Shares are of a 16:9 screen, times
// are of the CPU.

#include "bench/packing/bench.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <functional>
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

/// The tables of real regions that are wanted.
void print_real(const BenchOptions& options, const std::function<bool(std::string_view)>& wants) {
    const Items all = regions_of(options.catalogue);
    if (all.empty()) {
        fmt::print("\nno regions in '{}'\n", options.catalogue);
        return;
    }
    const Draw drawn = drawn_from(all);
    const std::string title = fmt::format("{} regions of the catalogue", all.size());
    if (wants("real")) print_shares(title.c_str(), drawn, options.instances, true);
    if (wants("bands")) print_bands(title.c_str(), drawn, options.instances, true);
    if (wants("turns")) print_band_turns(drawn, options.instances);
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
    if (wants("bands")) print_bands("random hulls", random_hulls, options.instances, false);
    if (!options.catalogue.empty()) print_real(options, wants);
    if (wants("edits")) print_edits(options.edits);
}
