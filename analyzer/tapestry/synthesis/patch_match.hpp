#pragma once

#include "analyzer/tapestry/synthesis/patch_image.hpp"
#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine::analyzer {

/// The place of the nearest patch in the other picture, as far as is known.
struct Match {
    std::int16_t x = -1;  // px of the patch's upper left pixel; -1: no match is searched
    std::int16_t y = -1;
    std::int32_t cost = 0;  // squared colour distance plus the cost of time
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

    std::vector<std::int16_t> owners;   // one a patch of S: the brick that it lies in wholly, or no_brick
    std::vector<std::uint8_t> weights;  // one a patch of S: how much the target must have it; 0: it need not
    std::vector<int> centres;           // one a brick: its middle, px of S
    int target_x = 0;                   // px of S where the target begins
    double reach = 1;                   // px from a brick's middle within which time costs nothing
    double time_cost = 0;               // cost of a squared px beyond it
};

/// Rules by which all patches of a source may be used anywhere, and none must be.
PatchRules free_rules(const PatchImage& source);

/// The matches of a source and a target with each other, and the search that improves them.
class PatchMatch {
  public:
    /// @param source, target, rules  outlive this
    PatchMatch(const PatchImage& source, const PatchImage& target, const PatchRules& rules);

    MatchField& of_target() { return of_target_; }

    MatchField& of_source() { return of_source_; }

    const MatchField& of_target() const { return of_target_; }

    const MatchField& of_source() const { return of_source_; }

    /// Computes all costs anew for the pictures as they are. Replaces matches that are not allowed by allowed
    /// ones.
    void refresh(const RunTasks& run);

    /// Sweeps once over both fields: each patch tries the matches of its neighbours, and searches places
    /// within `radius` px of its own match. No cost rises if all were up to date. The result follows from the
    /// seed.
    /// @param near_enough  a patch whose match costs less does not search; a searched place must be cheaper
    ///                     by half of this: so neighbours stay together, and a sweep ends sooner
    void search(int radius, std::uint32_t seed, const RunTasks& run, int near_enough = 0);

    /// Offers each field the matches of the other one, because a pair costs the same both ways.
    void share();

    /// Compares every patch with every other: for tests.
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
        bool is_target;  // the target's field; else the source's
        int first;
        int last;
    };

    using BandWork = std::function<void(const Band& band)>;

    /// Does the work for all bands of both fields, one task a band. The seed decides where the bands lie.
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
