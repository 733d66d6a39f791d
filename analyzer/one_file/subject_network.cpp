#include "analyzer/one_file/subject_network.hpp"

#include "base/system/atomic_file.hpp"

#include <cstddef>
#include <utility>

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

std::unique_ptr<SaliencyNetwork> quick_network(const AnalysisSettings& settings) {
    const std::string& model = settings.saliency_model;
    return settings.is_student ? std::make_unique<SaliencyNetwork>(model, coarse_side)
                               : open_network(model, coarse_side);
}

std::unique_ptr<SaliencyNetwork> spare_network(const AnalysisSettings& settings) {
    return std::make_unique<SaliencyNetwork>(settings.spare_model, coarse_side);
}

SubjectNetwork::SubjectNetwork(const std::string& file)
    : SubjectNetwork(std::make_unique<SaliencyNetwork>(file)) {
    if (auto coarse = open_network(file, coarse_side)) looks_.push_back(std::move(coarse));
}

SubjectNetwork::SubjectNetwork(std::unique_ptr<SaliencyNetwork> network) {
    looks_.push_back(std::move(network));
}

SaliencyMap SubjectNetwork::find(const FramePair& pair) {
    SaliencyMap sum = find_subject(*looks_.front(), pair);
    for (std::size_t i = 1; i < looks_.size(); ++i)
        sum += find_subject(*looks_[i], pair);
    return sum / static_cast<double>(looks_.size());
}

std::unique_ptr<SubjectNetwork> photo_network(const AnalysisSettings& settings) {
    if (settings.saliency_model.empty()) return nullptr;
    if (settings.is_student) return std::make_unique<SubjectNetwork>(quick_network(settings));
    return settings.looks_at_photos ? std::make_unique<SubjectNetwork>(settings.saliency_model) : nullptr;
}

}  // namespace vitrine::analyzer
