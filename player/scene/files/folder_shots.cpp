#include "player/scene/files/folder_shots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t max_files = 120;     // of a folder that are looked at
constexpr std::size_t max_shots = 4;       // of a film that are looked at
constexpr double telling_power = 0.5;      // weight of what a shot tells, beside its distance from others
constexpr double least_distance = 0.02;    // of shots that look the same
constexpr double of_other_folder = 0.6;    // distance without looks: of files in different folders
constexpr double of_other_file = 0.5;      // of files in one folder
constexpr double of_other_time = 0.3;      // of shots of one film
constexpr double largest_share = 0.35;     // an I-Region of this share of the picture tells most
constexpr double unknown_certainty = 0.5;  // the network was not asked

struct Candidate {
    RecordList::Record file;
    int shot = 0;
    double telling = 0;
    double distance = std::numeric_limits<double>::infinity();  // from the nearest chosen shot
};

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
}

void add_shots(std::vector<Candidate>& candidates, const RecordList::Record& file) {
    const std::size_t shots = file->shots.size();
    const std::size_t taken = std::min(shots, max_shots);
    for (std::size_t k = 0; k < taken; ++k) {
        const std::size_t shot = k * shots / taken;
        candidates.push_back(
            {.file = file, .shot = static_cast<int>(shot), .telling = telling(*file, file->shots[shot])});
    }
}

/// Shots of files that are evenly spread over the folder.
std::vector<Candidate> candidates_of(const RecordList& files, const std::set<std::string>& avoided) {
    std::vector<Candidate> candidates;
    const std::size_t taken = std::min(files.size(), max_files);
    std::size_t number = 0;
    std::size_t next = 0;
    for (const RecordList::Record& file : files) {
        if (number++ != next * files.size() / taken) continue;
        ++next;
        if (!avoided.contains(file->path)) add_shots(candidates, file);
    }
    return candidates;
}

void choose(const Candidate& chosen, std::vector<Candidate>& candidates) {
    for (Candidate& other : candidates)
        other.distance =
            std::min(other.distance, unlikeness(*chosen.file, chosen.shot, *other.file, other.shot));
}

double worth(const Candidate& candidate) {
    const double distance = std::min(1.0, std::max(candidate.distance, least_distance));
    return distance * std::pow(candidate.telling, telling_power);
}

}  // namespace

double telling(const MediaRecord& record, const Shot& shot) {
    constexpr double title_share = 0.3;  // words on a plain ground tell less than things do
    const double picture = static_cast<double>(record.width) * record.height;
    const double share = picture > 0 ? std::abs(signed_area(shot.region.polygon)) / picture : 0;
    const double size = std::clamp(share / largest_share, 0.05, 1.0);
    const double certainty = 0.5 + 0.5 * shot.certainty.value_or(unknown_certainty);
    return size * certainty * (shot.is_title ? title_share : 1);
}

double unlikeness(const MediaRecord& a, int shot_a, const MediaRecord& b, int shot_b) {
    const auto& look_a = a.shots[static_cast<std::size_t>(shot_a)].look;
    const auto& look_b = b.shots[static_cast<std::size_t>(shot_b)].look;
    if (a.path == b.path && shot_a == shot_b) return 0;
    if (look_a && look_b) return distance_between(*look_a, *look_b);
    if (a.path == b.path) return of_other_time;
    return folder_of(a.path) == folder_of(b.path) ? of_other_file : of_other_folder;
}

std::vector<ShotKey> folder_shots(const RecordList& files, std::span<const ShotKey> kept,
                                  const std::set<std::string>& avoided, std::size_t count) {
    std::vector<ShotKey> chosen(kept.begin(), kept.end());
    std::vector<Candidate> candidates = candidates_of(files, avoided);
    for (const ShotKey& key : kept)
        if (const RecordList::Record file = files.find(key.path))
            choose({.file = file, .shot = key.shot}, candidates);
    const auto is_chosen = [&](const Candidate& candidate) {
        return std::ranges::find(chosen, ShotKey{candidate.file->path, candidate.shot}) != chosen.end();
    };
    while (chosen.size() < count) {
        std::erase_if(candidates, is_chosen);
        const auto best = std::ranges::max_element(candidates, {}, worth);
        if (best == candidates.end()) break;
        const Candidate next = *best;
        chosen.push_back({next.file->path, next.shot});
        choose(next, candidates);
    }
    return chosen;
}

}  // namespace vitrine::player
