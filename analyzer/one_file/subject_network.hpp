#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/saliency/sample.hpp"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

constexpr int coarse_side = 160;  // px, of the input of a quick look, and of the student's

/// A network for pictures of a smaller side, with the weights of the file.
/// @return null where the model's input is not one of full_side
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> open_network(const std::string& file, int side);

/// The network of the settings, which name one, for quick looks: the student, or the large one with a smaller
/// input.
/// @return null like open_network()
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> quick_network(const AnalysisSettings& settings);

/// The spare network of the settings, which name one: the student.
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> spare_network(const AnalysisSettings& settings);

/// The networks as photos need them.
class SubjectNetwork {
  public:
    /// The large network looks at the picture as a whole and at a small one. The large look sees small things
    /// and outlines sharply; the small one takes in things that fill the picture. The subject is the mean of
    /// both, so that it is doubtful where they differ.
    /// @param file  ONNX
    /// @throws std::runtime_error if it cannot be read
    explicit SubjectNetwork(const std::string& file);

    /// One network looks once.
    explicit SubjectNetwork(std::unique_ptr<SaliencyNetwork> network);

    /// @return in px of the maps
    /// @throws std::runtime_error like SaliencyNetwork::map()
    SaliencyMap find(const FramePair& pair);

  private:
    std::vector<std::unique_ptr<SaliencyNetwork>> looks_;  // at least one
};

/// The network of the settings, as it looks at photos.
/// @return null: there is none, or it is the large one and is not to look
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SubjectNetwork> photo_network(const AnalysisSettings& settings);

}  // namespace vitrine::analyzer
