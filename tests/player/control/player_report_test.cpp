#include "player/control/player_report.hpp"

#include "player/control/analyzer_word.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <regex>
#include <set>
#include <sstream>

using namespace vitrine;
using namespace vitrine::player;

namespace {

PlayerReport drawn_report() {
    return {.state = ShowState::showing,
            .display = "'/dev/dri/card0' (atomic)",
            .screens = {{.name = "HDMI-A-1", .width = 1920, .height = 1080, .refresh = 60, .flips = 120}},
            .cells = {{.slot = 0, .path = "a.jpg"}, {.slot = 3, .path = "b \"\\\n\xff.mp4", .shot = 2}},
            .sources = {{.path = "a.jpg", .tier = "photo"},
                        {.path = "b \"\\\n\xff.mp4", .tier = "key", .is_stored = true, .late = 7}},
            .files = 9,
            .queue = 1,
            .pictures = 118,
            .late = 2,
            .film_late = 7,
            .rate = 29.97,
            .since_flip = std::chrono::milliseconds(33)};
}

/// Samples by name and labels. Fails on whatever the text format does not allow.
/// Source: Prometheus, exposition formats, text-based format.
std::map<std::string, double> parsed(const std::string& text) {
    static const std::regex help("# HELP ([a-zA-Z_:][a-zA-Z0-9_:]*) .+");
    static const std::regex type("# TYPE ([a-zA-Z_:][a-zA-Z0-9_:]*) (counter|gauge)");
    static const std::string label = R"re([a-zA-Z_]\w*="([^"\\]|\\["\\n])*")re";
    static const std::regex sample(R"re(([a-zA-Z_:][a-zA-Z0-9_:]*)(\{)re" + label + "(," + label +
                                   R"re()*\})? (-?[0-9.]+(e[+-]?[0-9]+)?))re");
    std::map<std::string, double> samples;
    std::set<std::string> families;
    std::string family;
    std::smatch match;
    REQUIRE(text.back() == '\n');
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        if (std::regex_match(line, match, help)) {
            REQUIRE(families.insert(match[1]).second);
            family = match[1];
        } else if (std::regex_match(line, match, type)) {
            REQUIRE(match[1] == family);
            REQUIRE((match[2] == "counter") == family.ends_with("_total"));
        } else {
            REQUIRE(std::regex_match(line, match, sample));
            REQUIRE(match[1] == family);
            REQUIRE(samples.emplace(match[1].str() + match[2].str(), std::stod(match[6])).second);
        }
    }
    return samples;
}

}  // namespace

TEST_CASE("systemd's line tells state, mode, cells, rate and the last flip") {
    const std::string line = one_line(drawn_report());
    for (const char* word :
         {"showing", "HDMI-A-1 1920x1080 at 60.00 Hz", "2 items of 9 files", "1 films play", "1 to come",
          "30.0 a second", "last flip 0.0 s ago", "118 pictures shown, 2 late"})
        CHECK_MESSAGE(line.find(word) != std::string::npos, line);
    PlayerReport dark;
    dark.display = "no graphics card to show on";
    CHECK(one_line(dark).starts_with("no panel: no graphics card to show on; 0 items"));
}

TEST_CASE("the answer for programs has it all, also with names that are no UTF-8") {
    const AnalyzerWord word = analyzer_word_from(
        R"({"online": true, "files": [{"path": "a", "state": "ready"}, {"path": "b", "state": "ready"}]})");
    const auto json = nlohmann::json::parse(to_json(drawn_report(), word.summary));
    CHECK(json.at("state") == "showing");
    CHECK(json.at("outputs").at(0).at("flips") == 120);
    CHECK(json.at("cells").at(1).at("shot") == 2);
    CHECK(json.at("sources").at(1).at("pictures") == "key");
    CHECK(json.at("analyzer").at("online") == true);
    CHECK(json.at("analyzer").at("states").at("ready") == 2);
    CHECK_FALSE(json.at("analyzer").contains("files"));
    CHECK(json.at("faults").empty());
    PlayerReport faulty;
    faulty.faults = {"output.canvas: 'A' is not there"};
    CHECK(nlohmann::json::parse(to_json(faulty, "")).at("faults") == nlohmann::json(faulty.faults));
}

TEST_CASE("of a file is told why it is not shown, with the analyzer's word for it") {
    const FileReport report{.path = "a.jpg",
                            .state = "waiting",
                            .visibility = {.path = "a.jpg",
                                           .visibility = Visibility::not_analysed,
                                           .detail = "it is still being copied"}};
    const std::string said = R"({"files": [{"path": "b"}, {"path": "a.jpg", "since": 5}]})";
    const auto json = nlohmann::json::parse(to_json(report, analyzer_word_from(said).entry("a.jpg")));
    CHECK(json.at("says") == "It has not been analysed yet: it is still being copied.");
    CHECK(json.at("wall") == "not_analysed");
    CHECK(json.at("analyzer").at("since") == 5);
    CHECK(analyzer_word_from(said).entry("c.jpg").empty());
    const AnalyzerWord nonsense = analyzer_word_from("no JSON");
    CHECK_FALSE(nlohmann::json::parse(to_json(report, nonsense.entry("a.jpg"))).contains("analyzer"));
    CHECK_FALSE(nlohmann::json::parse(to_json(drawn_report(), nonsense.summary)).contains("analyzer"));
}

TEST_CASE("the metrics are of the text format, whatever files are called") {
    const auto samples = parsed(to_metrics(drawn_report(), 61.5, {{"ready", 9}, {"waiting", 2}}));
    CHECK(samples.at("vitrine_frames_shown_total") == 118);
    CHECK(samples.at("vitrine_frames_late_total") == 2);
    CHECK(samples.at("vitrine_flips_total{output=\"HDMI-A-1\"}") == 120);
    CHECK(samples.at("vitrine_state{state=\"showing\"}") == 1);
    CHECK(samples.at("vitrine_state{state=\"no panel\"}") == 0);
    CHECK(samples.at("vitrine_sources{tier=\"key\"}") == 1);
    CHECK(samples.at(
              "vitrine_source_tier{source=\"1\",file=\"b \\\"\\\\\\n\xEF\xBF\xBD.mp4\",tier=\"key\"}") == 1);
    CHECK(samples.at("vitrine_files{state=\"waiting\"}") == 2);
    CHECK(samples.at("vitrine_temperature_celsius") == 61.5);
    CHECK_FALSE(parsed(to_metrics({}, {}, {})).contains("vitrine_temperature_celsius"));
}
