#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/saliency/sample.hpp"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Reads the model of a file.
/// @param side  px, as in look_size()
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> open_network(const std::string& file, int side);

/// The network of the settings, which name one, for quick looks: the student, or the large one with a smaller
/// input.
/// @return null where the model takes no smaller pictures
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> quick_network(const AnalysisSettings& settings);

/// The spare network of the settings, which name one: the student.
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> spare_network(const AnalysisSettings& settings);

/// The networks as photos need them.
class SubjectNetwork {
  public:
    /// The network looks at a large picture and at a small one. The large look sees small things and outlines
    /// sharply; the small one takes in things that fill the picture. The subject is the mean of both, so that
    /// it is doubtful where they differ. A model that takes one size only looks once.
    /// @param file  ONNX
    /// @throws std::runtime_error if it cannot be read
    SubjectNetwork(const std::string& file, bool is_student);

    /// @return in px of the maps
    /// @throws std::runtime_error like SaliencyNetwork::map()
    SaliencyMap find(const FramePair& pair);

  private:
    std::vector<SaliencyNetwork> looks_;  // at least one; they share one network
};

/// The network of the settings, as it looks at photos.
/// @return null: there is none, or it is the large one and is not to look
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SubjectNetwork> photo_network(const AnalysisSettings& settings);

}  // namespace vitrine::analyzer
