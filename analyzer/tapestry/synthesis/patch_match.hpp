#pragma once

#include "analyzer/tapestry/synthesis/patch_image.hpp"
#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine::analyzer {

/// Where in the other picture the patch nearest to one lies, as far as is known.
struct Match {
    std::int16_t x = -1;  // px of the patch's upper left pixel; -1: none is looked for
    std::int16_t y = -1;
    std::int32_t cost = 0;  // squared colour distance and what time adds
};

/// A match for each patch of a picture, row by row.
struct MatchField {
    int columns = 0;
    int rows = 0;
    std::vector<Match> matches;

    MatchField() = default;

    MatchField(int field_columns, int field_rows)
        : columns(field_columns),
          rows(field_rows),
          matches(static_cast<std::size_t>(field_columns) * static_cast<std::size_t>(field_rows)) {}

    Match& at(int x, int y) {
        return matches[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x)];
    }

    const Match& at(int x, int y) const {
        return matches[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x)];
    }
};

/// The patches of a source S that a target T may use, their costs beyond colour, and the patches that the
/// target must have.
struct PatchRules {
    static constexpr int no_brick = -1;

    std::vector<std::int16_t>
        owners;  // a patch of S: its brick, or no_brick where it lies in none as a whole
    std::vector<std::uint8_t> weights;  // a patch of S: how much the target must have it; 0: it need not
    std::vector<int> centres;           // a brick: the middle, px of S
    int target_x = 0;                   // px of S where the target begins
    double reach = 1;                   // px from a brick's middle within which time costs nothing
    double time_cost = 0;               // a squared px beyond it
};

/// The rules of a source whose patches may all be used anywhere, and none must be.
PatchRules free_rules(const PatchImage& source);

/// The two fields of a source and a target, and the search that improves them.
class PatchMatch {
  public:
    /// @param source, target, rules  outlive this
    PatchMatch(const PatchImage& source, const PatchImage& target, const PatchRules& rules);

    MatchField& of_target() { return of_target_; }

    MatchField& of_source() { return of_source_; }

    const MatchField& of_target() const { return of_target_; }

    const MatchField& of_source() const { return of_source_; }

    /// Brings all costs up to date with the pictures; matches that may not be are replaced by ones that may.
    void refresh(const RunTasks& run);

    /// One sweep over both fields: each patch tries what its neighbours have found, and some more within
    /// `radius` px of its own. No cost rises, where it was up to date. What it gives follows from the seed.
    /// @param near_enough  what costs less tries only its neighbours' finds, and nothing far is taken for
    /// half
    ///                     of it less: neighbours stay together, and a sweep is sooner done
    void search(int radius, std::uint32_t seed, const RunTasks& run, int near_enough = 0);

    /// Each field takes what the other one found: a pair costs the same both ways.
    void share();

    /// Every patch is compared with every other: for tests.
    void search_everywhere();

    /// Mean cost a channel value, weighted over the source's patches plus over the target's.
    /// Source: Video Tapestries 3, eq. 1 with the distance of eq. 2.
    double energy() const;

    double source_weight() const { return source_weight_; }

    /// The cost of a pair; `bound` as in PatchDistance.
    int cost(int source_x, int source_y, int target_x, int target_y, int bound) const;

    bool is_allowed(int source_x, int source_y) const {
        return owner(source_x, source_y) != PatchRules::no_brick;
    }

  private:
    struct Sweep;

    /// Rows [first, last) of one of the fields.
    struct Band {
        int task;
        bool is_target;  // whose field
        int first;
        int last;
    };

    using BandWork = std::function<void(const Band& band)>;

    /// Does the work for both fields, a task a band; where the bands lie follows from the seed.
    void in_bands(std::uint32_t seed, const RunTasks& run, const BandWork& work) const;

    int owner(int x, int y) const { return rules_.owners[place(x, y)]; }

    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(of_source_.columns) +
               static_cast<std::size_t>(x);
    }

    int time_cost(int source_x, int source_y, int target_x) const;
    Match allowed_near(int x, int y) const;
    void refresh_row_of_target(int y);
    void refresh_row_of_source(int y);

    const PatchImage& source_;
    const PatchImage& target_;
    const PatchRules& rules_;
    PatchDistance distance_;
    MatchField of_target_;
    MatchField of_source_;
    double source_weight_ = 0;  // sum of all weights
};

}  // namespace vitrine::analyzer
