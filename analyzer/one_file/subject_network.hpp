#pragma once

#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/saliency/sample.hpp"

#include <memory>
#include <string>

namespace vitrine::analyzer {

constexpr int coarse_side = 160;  // px, of the input of a quick look

/// A network for pictures of a smaller side, with the weights of the file.
/// @return null where the model's input is not one of full_side
/// @throws std::runtime_error if it cannot be read
std::unique_ptr<SaliencyNetwork> open_network(const std::string& file, int side);

/// The network as photos need it: it looks at the picture as a whole and at a small one. The large look sees
/// small things and outlines sharply; the small one takes in things that fill the picture. The subject is the
/// mean of both, so that it is doubtful where they differ.
class SubjectNetwork {
  public:
    /// @param file  ONNX
    /// @throws std::runtime_error if it cannot be read
    explicit SubjectNetwork(const std::string& file);

    /// @return in px of the maps
    /// @throws std::runtime_error like SaliencyNetwork::map()
    SaliencyMap find(const FramePair& pair);

  private:
    SaliencyNetwork full_;
    std::unique_ptr<SaliencyNetwork> coarse_;  // null: the model has one size only
};

}  // namespace vitrine::analyzer
