#include "player/stage/output_faults.hpp"

#include "base/settings/settings.hpp"
#include "player/display/offscreen_display.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/stage/output_canvas.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

using Faults = std::vector<std::string>;

/// Two screens in memory, of 100x50 and 80x50 px, and the outputs of another box.
struct Outputs {
    Faults faults() {
        found.look(settings, display.screens(), others, files);
        return found.all();
    }

    Faults faults_of_canvas(const std::string& canvas) {
        settings.output.canvas = canvas;
        return faults();
    }

    Faults faults_of_folders(const std::string& folders) {
        settings.output.folders = folders;
        return faults();
    }

    Settings settings;
    OffscreenDisplay display{{.screens = {{100, 50}, {80, 50}}}, {}, 30};
    OtherOutputs others;
    RecordList files;
    OutputFaults found;
};

}  // namespace

TEST_CASE("outputs that overlap on the canvas with their modes are told") {
    Outputs outputs;
    CHECK(outputs.faults_of_canvas("offscreen-1 0,0; offscreen-2 90,0") ==
          Faults{"output.canvas: 'offscreen-1' and 'offscreen-2' overlap, with the modes that they have"});
    CHECK(outputs.faults_of_canvas("offscreen-1 0,0; offscreen-2 100,0").empty());
    CHECK(outputs.faults_of_canvas("").empty());
}

TEST_CASE("a canvas that names an output that is not there in place of one that is, is told") {
    Outputs outputs;
    CHECK(
        outputs.faults_of_canvas("offscreen-1 0,0; OFFSCREEN-2 110,0") ==
        Faults{"output.canvas: 'OFFSCREEN-2' is not there, and 'offscreen-2', which has no place, shows the "
               "whole wall"});
    CHECK(outputs.faults_of_canvas("offscreen-1 0,0").empty());
    CHECK(outputs.faults_of_canvas("offscreen-1 0,0; offscreen-2 110,0; offscreen-3 200,0").empty());
}

TEST_CASE(
    "on the canvas of several boxes an output counts with its box, and a box that follows tells nothing") {
    Outputs outputs;
    outputs.settings.wall = {.role = WallRole::lead, .box = "here"};
    CHECK(outputs.faults_of_canvas("here/offscreen-1 0,0; offscreen-2 110,0").empty());
    CHECK(
        outputs.faults_of_canvas("offscreen-1 0,0; hall/offscreen-2 110,0") ==
        Faults{"output.canvas: 'hall/offscreen-2' is not there, and 'offscreen-2', which has no place, shows "
               "the whole wall"});
    outputs.others.outputs = {{"hall/HDMI-A-1", 100, 50, {}}};
    CHECK(
        outputs.faults_of_canvas("offscreen-1 0,0; offscreen-2 110,0; hall/hdmi 200,0") ==
        Faults{"output.canvas: 'hall/hdmi' is not there, and 'hall/HDMI-A-1', which has no place, shows the "
               "whole wall"});
    outputs.settings.wall.role = WallRole::follow;
    CHECK(outputs.faults().empty());
}

TEST_CASE("a folder of an output that is not there in place of one that is, is told") {
    Outputs outputs;
    CHECK(outputs.faults_of_folders("offscreen-1=hall, OFFSCREEN-2=lobby") ==
          Faults{
              "output.folders: 'OFFSCREEN-2' is not there, and 'offscreen-2', which has no folder, shows the "
              "whole media folder"});
    CHECK(outputs.faults_of_folders("offscreen-1=hall").empty());
    CHECK(outputs.faults_of_folders("offscreen-1=hall, offscreen-2=lobby, HDMI-A-1=lobby").empty());
}

TEST_CASE("an output that has a folder needs no place on the canvas, and one on the canvas needs no folder") {
    Outputs outputs;
    outputs.settings.output.folders = "offscreen-2=hall";
    CHECK(outputs.faults_of_canvas("offscreen-1 0,0; HDMI-A-2 110,0").empty());
    CHECK(outputs.faults_of_folders("offscreen-2=hall, HDMI-A-3=lobby").empty());
    CHECK(outputs.faults_of_canvas("HDMI-A-2 110,0").size() == 2);
}

TEST_CASE("while no output is there, the last faults are kept") {
    Outputs outputs;
    const Faults before = outputs.faults_of_folders("OFFSCREEN-1=hall");
    REQUIRE(before.size() == 1);
    outputs.found.look(outputs.settings, {}, {}, {});
    CHECK(outputs.found.all() == before);
}

TEST_CASE("a leader whose outputs are off tells of those of other boxes, and does not miss its own") {
    Outputs outputs;
    outputs.settings.wall = {.role = WallRole::lead, .box = "here"};
    outputs.settings.output.canvas = "here/offscreen-1 0,0; hall/hdmi 200,0";
    outputs.others.outputs = {{"hall/HDMI-A-1", 100, 50, {}}};
    outputs.found.look(outputs.settings, {}, outputs.others, {});
    CHECK(
        outputs.found.all() ==
        Faults{"output.canvas: 'hall/hdmi' is not there, and 'hall/HDMI-A-1', which has no place, shows the "
               "whole wall"});
    outputs.settings.output.canvas = "here/offscreen-1 0,0";
    outputs.found.look(outputs.settings, {}, outputs.others, {});
    CHECK(outputs.found.all().empty());
}

TEST_CASE("an output whose folder has no files is told, once there are others") {
    Outputs outputs;
    CHECK(outputs.faults_of_folders("offscreen-1=hall, offscreen-2=lobby").empty());
    MediaRecord file;
    file.path = "hall/a.jpg";
    std::vector<MediaRecord> files{file};
    outputs.files = files;
    CHECK(outputs.faults() ==
          Faults{"output.folders: 'offscreen-2' shows nothing: its folder 'lobby' has no files"});
    file.path = "lobby/b.jpg";
    files.push_back(file);
    outputs.files = files;
    CHECK(outputs.faults().empty());
}
