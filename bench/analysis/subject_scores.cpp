#include "bench/analysis/subject_scores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace vitrine::analyzer {

namespace {

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(1, values.size()));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = mean(a);
    const double mean_b = mean(b);
    double both = 0;
    double only_a = 0;
    double only_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += (a[i] - mean_a) * (b[i] - mean_b);
        only_a += (a[i] - mean_a) * (a[i] - mean_a);
        only_b += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return both / std::sqrt(std::max(1e-12, only_a * only_b));
}

}  // namespace

double lowest_tenth(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return mean(std::span(values).first((values.size() + 9) / 10));
}

void SubjectScores::add(const RegionScore& s, double subject_area) {
    faces += s.faces;
    whole_faces += s.whole_faces;
    if (subject_area <= 0) return;
    subject.push_back(subject_area);
    coverage.push_back(s.coverage);
    area.push_back(s.area);
    iou.push_back(s.iou);
}

void print_scores_head() {
    fmt::print("{:22} {:>6} {:>6} {:>7} {:>6} {:>6} {:>6} {:>8}\n", "", "mean", "worst", "median", "mean",
               "IoU", "follows", "faces");
}

void print_scores(const char* name, SubjectScores s) {
    if (s.coverage.empty()) return;
    const double follows = correlation(s.area, s.subject);
    std::sort(s.area.begin(), s.area.end());
    fmt::print("{:22} {:6.3f} {:6.3f} {:7.3f} {:6.3f} {:6.3f} {:6.2f} {:6}/{}\n", name, mean(s.coverage),
               lowest_tenth(s.coverage), s.area[s.area.size() / 2], mean(s.area), mean(s.iou), follows,
               s.whole_faces, s.faces);
}

}  // namespace vitrine::analyzer
