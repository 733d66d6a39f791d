#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/saliency/sample.hpp"
#include "base/state/record.hpp"

#include <memory>
#include <vector>

namespace vitrine::analyzer {

/// Lets the network look at a few samples of each shot of a film, at a small size. The looks are few beside
/// what decoding costs: a film earns them by its pixels, and a shot for which none is left keeps its plain
/// region. Logs a model that cannot be used, once, and does without it.
class SubjectLooks {
  public:
    /// @param film  its size; no look is taken where it is a photo
    SubjectLooks(const AnalysisSettings& settings, const MediaRecord& film);

    /// Fills the subject of some samples.
    /// @param samples  of the shot, with their glances
    void look(const Shot& shot, std::vector<Sample>& samples);

  private:
    int affordable(const Shot& shot) const;
    bool open();

    const AnalysisSettings& settings_;  // outlives the looks
    double rate_ = 0;                   // looks a second of film
    int taken_ = 0;
    bool is_off_ = false;
    std::unique_ptr<SaliencyNetwork> network_;  // null: not opened yet
};

}  // namespace vitrine::analyzer
