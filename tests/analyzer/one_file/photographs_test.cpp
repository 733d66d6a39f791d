#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analyze.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

struct Labels {
    std::vector<Box> subjects;  // fractions of the picture
    std::vector<Box> faces;
};

std::vector<Box> boxes(const nlohmann::json& entry, const char* key) {
    std::vector<Box> result;
    if (!entry.contains(key)) return result;
    for (const auto& b : entry[key]) {
        result.push_back(
            {{b[0].get<double>(), b[1].get<double>()}, {b[2].get<double>(), b[3].get<double>()}});
    }
    return result;
}

bool holds(const MediaRecord& record, Vec2 fraction) {
    return is_inside_convex(record.shots.at(0).region.polygon,
                            {fraction.x * record.width, fraction.y * record.height}, 1);
}

}  // namespace

TEST_CASE("small heads in a film lie in its region" * doctest::test_suite("real")) {
    AnalysisSettings settings;
    settings.face_model = VITRINE_FACE_MODEL;
    settings.saliency_model = (fs::path(VITRINE_FACE_MODEL).parent_path() / "u2netp.onnx").string();
    const fs::path film = fs::path(VITRINE_MEDIA) / "single" / "chaplin.mp4";
    const MediaRecord record = analyze(*open_media(film.string()), settings);
    REQUIRE(record.shots.size() == 1);
    CHECK(holds(record, {372.0 / 640, 35.0 / 360}));  // his forehead at 4.8 s
    CHECK(holds(record, {345.0 / 640, 44.0 / 360}));  // and at 4.4 s
}

TEST_CASE("of labelled photographs nearly all faces and the middle of most subjects are in the region" *
          doctest::test_suite("real")) {
    const fs::path media = VITRINE_MEDIA;
    std::ifstream file(media / "photos" / "boxes.json");
    REQUIRE(file);
    AnalysisSettings settings;
    settings.face_model = VITRINE_FACE_MODEL;
    int faces = 0;
    int held_faces = 0;
    int subjects = 0;
    int held_subjects = 0;
    const nlohmann::json labels = nlohmann::json::parse(file);
    for (const auto& [name, entry] : labels["images"].items()) {
        const MediaRecord record = analyze(*open_media((media / "photos" / name).string()), settings);
        for (const Box& face : boxes(entry, "face")) {
            ++faces;
            held_faces += holds(record, face.centre()) ? 1 : 0;
        }
        for (const Box& subject : boxes(entry, "subject")) {
            ++subjects;
            held_subjects += holds(record, subject.centre()) ? 1 : 0;
        }
        CHECK(area(record.shots.at(0).region.polygon) < 0.9 * record.width * record.height);
    }
    CHECK(held_faces >= 0.85 * faces);
    CHECK(held_subjects >= 0.85 * subjects);
}
