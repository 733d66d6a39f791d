#pragma once

#include "analyzer/film/dissolve_finder.hpp"
#include "analyzer/film/fade_finder.hpp"
#include "analyzer/film/feature_window.hpp"
#include "analyzer/film/transition.hpp"
#include "analyzer/film/wipe_finder.hpp"

#include <vector>

namespace vitrine::analyzer {

/// Runs the finders over a film and joins their results: a cut inside a dissolve or a fade is part of it, and
/// gradual transitions that touch are one. Memory is bounded by FeatureWindow.
class TransitionDetector {
  public:
    /// @return  the transitions that nothing later can change any more, in time order
    std::vector<Transition> push(const FrameFeatures& frame);

    /// The transitions still open. @param end  end of the last frame
    std::vector<Transition> finish(std::chrono::nanoseconds end);

  private:
    void judge(std::size_t frame);
    bool is_flash(const Transition& found) const;
    bool is_dissolve(const Transition& found) const;
    void add_dissolve(const Transition& found);
    void add(const Transition& found);
    bool is_settled(const Transition& found) const;

    FeatureWindow window_;
    DissolveFinder dissolves_;
    WipeFinder wipes_;
    FadeFinder fades_;
    std::vector<Transition> pending_;  // in time order, not overlapping
    std::size_t judged_ = 0;           // frames before this one are judged
    std::size_t faded_ = 0;            // the first frame after the last fade
    std::size_t since_ = 0;            // the first frame after the last transition
};

}  // namespace vitrine::analyzer
