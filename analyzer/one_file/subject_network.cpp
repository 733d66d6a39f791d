#include "analyzer/one_file/subject_network.hpp"

#include "base/system/atomic_file.hpp"

#include <cstddef>

namespace vitrine::analyzer {
namespace {

constexpr std::size_t max_model = std::size_t{1} << 30U;  // bytes; u2net has 176 MB

}  // namespace

std::unique_ptr<SaliencyNetwork> open_network(const std::string& file, int side) {
    const std::string model = read_file(file, max_model);
    const std::string smaller = with_input_side(model, side);
    if (smaller == model) return nullptr;
    return std::make_unique<SaliencyNetwork>(file, smaller, side);
}

SubjectNetwork::SubjectNetwork(const std::string& file)
    : full_(file), coarse_(open_network(file, coarse_side)) {}

SaliencyMap SubjectNetwork::find(const FramePair& pair) {
    SaliencyMap full = find_subject(full_, pair);
    if (!coarse_) return full;
    return (full + find_subject(*coarse_, pair)) / 2;
}

}  // namespace vitrine::analyzer
