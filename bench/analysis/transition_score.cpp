#include "bench/analysis/transition_score.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

nanoseconds time_of(double frame, double fps) {
    return nanoseconds(static_cast<std::int64_t>(frame / fps * 1e9));
}

// The times of a film's frames: evenly spread, or as the truth's "times" say.
class FrameTimes {
  public:
    explicit FrameTimes(const nlohmann::json& json)
        : fps_(std::stod(json.at("fps").get<std::string>())),
          seconds_(json.value("times", std::vector<double>())) {}

    double fps() const { return fps_; }

    nanoseconds at(std::size_t frame) const {
        if (seconds_.empty()) return time_of(static_cast<double>(frame), fps_);
        if (frame >= seconds_.size()) return time_of(1, fps_) + at(seconds_.size() - 1);
        return time_of(seconds_[frame], 1);
    }

    Transition gradual(std::size_t first, std::size_t last, ShotEnd kind) const {
        return {at(first), at(last + 1), kind};
    }

  private:
    double fps_;
    std::vector<double> seconds_;
};

/// The stretches without those that are no pictures.
std::vector<Stretch> without(std::vector<Stretch> stretches, const std::vector<Transition>& others) {
    for (const Transition& other : others) {
        if (other.end <= other.begin) continue;
        std::vector<Stretch> left;
        for (const Stretch& stretch : stretches) {
            const Stretch before{stretch.begin, std::min(stretch.end, other.begin)};
            const Stretch after{std::max(stretch.begin, other.end), stretch.end};
            for (const Stretch& part : {before, after})
                if (part.begin < part.end) left.push_back(part);
        }
        stretches = std::move(left);
    }
    return stretches;
}

/// The stretches of the shots, or the whole film where the truth has none, without transitions and what is
/// ignored.
std::vector<Stretch> pictures_of(const nlohmann::json& json, const FrameTimes& times, const Truth& truth) {
    std::vector<Stretch> pictures;
    for (const auto& shot : json.value("shots", nlohmann::json::array()))
        pictures.push_back({times.at(shot.at(0)), times.at(shot.at(1).get<std::size_t>() + 1)});
    if (pictures.empty()) pictures.push_back({times.at(0), times.at(json.at("frames"))});
    return without(without(std::move(pictures), truth.transitions), truth.ignored);
}

Truth read_truth(const nlohmann::json& json) {
    const FrameTimes times(json);
    Truth truth{.file = json.at("file"), .fps = times.fps()};
    for (const auto& entry : json.at("transitions")) {
        if (entry.at("type") == "cut") {
            const nanoseconds at = times.at(entry.at("frame"));
            truth.transitions.push_back({at, at, ShotEnd::cut});
        } else {
            const auto kind = entry.at("type") == "dissolve" ? ShotEnd::dissolve : ShotEnd::fade;
            truth.transitions.push_back(times.gradual(entry.at("start"), entry.at("end"), kind));
        }
    }
    for (const auto& range : json.value("ignore", nlohmann::json::array()))
        truth.ignored.push_back(times.gradual(range.at(0), range.at(1), ShotEnd::fade));
    truth.is_one_take = truth.transitions.empty();
    if (!truth.is_one_take && json.contains("frames")) truth.pictures = pictures_of(json, times, truth);
    return truth;
}

// A list of films of one take: their names beside the folder of the truths.
void read_takes(const nlohmann::json& json, const std::string& folder, std::vector<Truth>& truths) {
    for (const auto& [name, ignored] : json.at("files").items()) {
        truths.push_back({.file = folder + "/" + name, .is_one_take = true});
        for (const auto& range : ignored)
            truths.back().ignored.push_back(
                {time_of(range.at(0), 1), time_of(range.at(1), 1), ShotEnd::fade});
    }
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

Score& Score::operator+=(const Score& other) {
    cuts += other.cuts;
    gradual += other.gradual;
    all += other.all;
    return *this;
}

Score score_of(const Truth& truth, const std::vector<Transition>& found, Names names) {
    const Judge judge(truth, found);
    Score score;
    for (const Transition& true_one : truth.transitions) {
        Tally& tally = is_cut(true_one) ? score.cuts : score.gradual;
        const bool hit = judge.is_found(true_one, names == Names::none && !is_cut(true_one));
        ++(hit ? tally.found : tally.missed);
        ++(judge.is_found(true_one, true) ? score.all.found : score.all.missed);
        if (!hit) score.mistakes.push_back("missed " + name(true_one));
    }
    for (const Transition& one : found) {
        if (!judge.is_judged(one)) continue;
        const bool is_somewhere = judge.is_true(one, true);
        if (!is_somewhere) ++score.all.false_alarms;
        if (names == Names::none ? is_somewhere : judge.is_true(one, false)) continue;
        ++(is_cut(one) ? score.cuts : score.gradual).false_alarms;
        score.mistakes.push_back("false " + name(one));
    }
    return score;
}

std::vector<Truth> read_truths(const std::filesystem::path& folder) {
    std::vector<Truth> truths;
    for (const auto& part : std::filesystem::directory_iterator(folder)) {
        if (!std::filesystem::is_directory(part.path() / "gt")) continue;
        for (const auto& entry : std::filesystem::directory_iterator(part.path() / "gt")) {
            std::ifstream file(entry.path());
            const auto json = nlohmann::json::parse(file);
            if (json.contains("transitions"))
                truths.push_back(read_truth(json));
            else if (json.contains("files"))
                read_takes(json, part.path().filename(), truths);
        }
    }
    std::ranges::sort(truths, {}, &Truth::file);
    return truths;
}

}  // namespace vitrine::analyzer
