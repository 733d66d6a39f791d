#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/saliency/sample.hpp"
#include "base/state/record.hpp"

#include <memory>
#include <vector>

namespace vitrine::analyzer {

/// The pace at which a network looks at a film.
struct LookPace {
    double pixels = 0;   // of one picture of the film, for one look earned a second
    double seconds = 0;  // of a shot, for one look more than the first
    double at_once = 0;  // looks before anything is earned
    int max = 0;         // looks in a shot
};

/// Lets the network look at some samples of each shot of a film, at a small size. The looks are few beside
/// what decoding costs: a film earns them by its pixels. At a shot for which none is left the spare network
/// looks, if there is one; else the shot keeps its plain region. Logs a model that cannot be used, once, and
/// does without it.
class SubjectLooks {
  public:
    /// @param film  its size; no look is taken where it is a photo
    SubjectLooks(const AnalysisSettings& settings, const MediaRecord& film);

    /// Fills the subject of some samples.
    /// @param samples  of the shot, with their glances
    void look(const Shot& shot, std::vector<Sample>& samples);

  private:
    /// A network that looks, opened when it looks first.
    struct Looker {
        std::unique_ptr<SaliencyNetwork> (*open)(const AnalysisSettings& settings) = nullptr;
        bool is_off = false;
        std::unique_ptr<SaliencyNetwork> network = {};  // null: not opened yet
    };

    /// @return the number of samples at which it has looked
    int look(Looker& looker, int count, const Shot& shot, std::vector<Sample>& samples);
    int affordable(const Shot& shot) const;

    const AnalysisSettings& settings_;  // outlives the looks
    LookPace pace_;
    double rate_ = 0;  // looks a second of film
    int taken_ = 0;    // of the first network
    Looker first_;
    Looker spare_;
};

}  // namespace vitrine::analyzer
