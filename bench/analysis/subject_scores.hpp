#pragma once

#include "bench/analysis/region_score.hpp"

#include <vector>

namespace vitrine::analyzer {

/// Measures of regions against the subjects of many photographs.
struct SubjectScores {
    std::vector<double> coverage;
    std::vector<double> area;
    std::vector<double> subject;  // area, share of the picture
    std::vector<double> iou;
    int faces = 0;
    int whole_faces = 0;

    /// @param subject_area  share of the picture; 0: there is no subject
    void add(const RegionScore& s, double subject_area);
};

/// The mean of the lowest tenth of the values.
double lowest_tenth(std::vector<double> values);

/// The names of the columns of print_scores().
void print_scores_head();

/// A row: the share of subjects inside, mean and the mean of the worst 10 %; the region's share of the
/// picture, median and mean; overlap; correlation of that share with the subject's; faces wholly inside. No
/// row without a subject.
void print_scores(const char* name, SubjectScores scores);

}  // namespace vitrine::analyzer
