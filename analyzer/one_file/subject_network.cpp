#include "analyzer/one_file/subject_network.hpp"

#include "base/system/atomic_file.hpp"

#include <cstddef>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr std::size_t max_model = std::size_t{1} << 30U;  // bytes; u2net has 176 MB
constexpr int student_side = 224;                         // px, of the larger look of the student

std::shared_ptr<Network> read_network(const std::string& file) {
    return std::make_shared<Network>("saliency model '" + file + "'", read_file(file, max_model));
}

}  // namespace

std::unique_ptr<SaliencyNetwork> open_network(const std::string& file, int side) {
    return std::make_unique<SaliencyNetwork>(read_network(file), side);
}

std::unique_ptr<SaliencyNetwork> quick_network(const AnalysisSettings& settings) {
    auto network = open_network(settings.saliency_model, coarse_side);
    return settings.is_student || network->is_scalable() ? std::move(network) : nullptr;
}

std::unique_ptr<SaliencyNetwork> spare_network(const AnalysisSettings& settings) {
    return open_network(settings.spare_model, coarse_side);
}

SubjectNetwork::SubjectNetwork(const std::string& file, bool is_student) {
    const std::shared_ptr<Network> network = read_network(file);
    looks_.emplace_back(network, is_student ? coarse_side : full_side);
    if (looks_.front().is_scalable()) looks_.emplace_back(network, is_student ? student_side : coarse_side);
}

SaliencyMap SubjectNetwork::find(const FramePair& pair) {
    SaliencyMap sum = find_subject(looks_.front(), pair);
    for (std::size_t i = 1; i < looks_.size(); ++i)
        sum += find_subject(looks_[i], pair);
    return sum / static_cast<double>(looks_.size());
}

std::unique_ptr<SubjectNetwork> photo_network(const AnalysisSettings& settings) {
    if (settings.saliency_model.empty()) return nullptr;
    if (!settings.is_student && !settings.looks_at_photos) return nullptr;
    return std::make_unique<SubjectNetwork>(settings.saliency_model, settings.is_student);
}

}  // namespace vitrine::analyzer
