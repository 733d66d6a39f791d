#include "tests/bench/analysis/transition_score.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vitrine {

namespace {

using std::chrono::nanoseconds;

nanoseconds time_of(double frame, double fps) {
    return nanoseconds(static_cast<std::int64_t>(frame / fps * 1e9));
}

Transition gradual(double first, double last, double fps, ShotEnd kind) {
    return {time_of(first, fps), time_of(last + 1, fps), kind};
}

Truth read_truth(const nlohmann::json& json) {
    Truth truth{.file = json.at("file"), .fps = std::stod(json.at("fps").get<std::string>())};
    for (const auto& entry : json.at("transitions")) {
        if (entry.at("type") == "cut") {
            const nanoseconds at = time_of(entry.at("frame"), truth.fps);
            truth.transitions.push_back({at, at, ShotEnd::cut});
        } else {
            const auto kind = entry.at("type") == "dissolve" ? ShotEnd::dissolve : ShotEnd::fade;
            truth.transitions.push_back(gradual(entry.at("start"), entry.at("end"), truth.fps, kind));
        }
    }
    for (const auto& range : json.value("ignore", nlohmann::json::array()))
        truth.ignored.push_back(gradual(range.at(0), range.at(1), truth.fps, ShotEnd::fade));
    return truth;
}

bool overlap(const Transition& a, const Transition& b, nanoseconds tolerance) {
    return a.begin <= b.end + tolerance && b.begin <= a.end + tolerance;
}

bool is_cut(const Transition& transition) {
    return transition.kind == ShotEnd::cut;
}

std::string name(const Transition& t) {
    const double begin = static_cast<double>(t.begin.count()) / 1e9;
    const double end = static_cast<double>(t.end.count()) / 1e9;
    return is_cut(t) ? fmt::format("cut {:.2f}", begin) : fmt::format("gradual {:.2f}-{:.2f}", begin, end);
}

class Judge {
  public:
    Judge(const Truth& truth, const std::vector<Transition>& found)
        : truth_(truth), found_(found), frame_(time_of(1, truth.fps)) {}

    bool is_found(const Transition& true_one, bool any_kind) const {
        return std::ranges::any_of(found_, [&](const Transition& other) {
            if (any_kind) return overlap(true_one, other, 2 * frame_);
            if (!is_cut(true_one)) return !is_cut(other) && overlap(true_one, other, 2 * frame_);
            return near(true_one.begin, other.begin) || near(true_one.begin, other.end);
        });
    }

    bool is_true(const Transition& found, bool any_kind) const {
        const auto agrees = [&](const Transition& other) {
            if (any_kind) return overlap(found, other, 2 * frame_);
            if (is_cut(found)) return is_cut(other) && near(found.begin, other.begin);
            return overlap(found, other, 2 * frame_) && (!is_cut(other) || touches_plain(other));
        };
        return std::ranges::any_of(truth_.transitions, agrees);
    }

    bool is_judged(const Transition& transition) const {
        return std::ranges::none_of(
            truth_.ignored, [&](const Transition& range) { return overlap(transition, range, frame_); });
    }

  private:
    bool near(nanoseconds a, nanoseconds b) const { return std::chrono::abs(a - b) <= frame_ * 3 / 2; }

    // a cut to or from black or white stands next to a fade
    bool touches_plain(const Transition& cut) const {
        return std::ranges::any_of(truth_.transitions, [&](const Transition& other) {
            return !is_cut(other) && overlap(cut, other, 15 * frame_);
        });
    }

    const Truth& truth_;
    const std::vector<Transition>& found_;
    nanoseconds frame_;
};

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
    found += other.found;
    missed += other.missed;
    false_alarms += other.false_alarms;
    return *this;
}

double Tally::f1() const {
    const int twice = 2 * found;
    return twice == 0 ? 0 : static_cast<double>(twice) / (twice + missed + false_alarms);
}

Score score_of(const Truth& truth, const std::vector<Transition>& found) {
    const Judge judge(truth, found);
    Score score;
    for (const Transition& true_one : truth.transitions) {
        Tally& tally = is_cut(true_one) ? score.cuts : score.gradual;
        const bool hit = judge.is_found(true_one, false);
        ++(hit ? tally.found : tally.missed);
        ++(judge.is_found(true_one, true) ? score.all.found : score.all.missed);
        if (!hit) score.mistakes.push_back("missed " + name(true_one));
    }
    for (const Transition& one : found) {
        if (!judge.is_judged(one)) continue;
        if (!judge.is_true(one, false)) {
            ++(is_cut(one) ? score.cuts : score.gradual).false_alarms;
            score.mistakes.push_back("false " + name(one));
        }
        if (!judge.is_true(one, true)) ++score.all.false_alarms;
    }
    return score;
}

std::vector<Truth> read_truths(const std::string& folder) {
    std::vector<Truth> truths;
    for (const char* part : {"edited/gt", "composites/gt"}) {
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(folder) / part)) {
            std::ifstream file(entry.path());
            truths.push_back(read_truth(nlohmann::json::parse(file)));
        }
    }
    std::ranges::sort(truths, {}, &Truth::file);
    return truths;
}

}  // namespace vitrine
