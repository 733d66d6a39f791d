#pragma once

#include "base/settings/choices.hpp"
#include "base/system/log.hpp"

#include <chrono>
#include <cstdint>
#include <string>

namespace vitrine {

/// All settings with their defaults. setting_keys() has the allowed values and explanations.
struct Settings {
    struct Media {
        std::string root = "/srv/vitrine/media";
    } media;

    struct State {
        std::string directory = "/var/lib/vitrine";
    } state;

    struct Store {
        std::int64_t max_bytes = std::int64_t{8} << 30;  // limit for copies and clips; 0: none are made
        int clip_size = 0;  // px, longest side of a clip; 0: as large as layout.slots makes cells
    } store;

    struct Tapestry {
        std::int64_t max_bytes = std::int64_t{2} << 30;  // limit for all films' tapestries; 0: none are made
        int height = 0;                                  // px; 0: as tall as the screens need
    } tapestry;

    struct Status {
        std::string folder = "_STATUS";  // in the media folder; empty: none
        bool played = true;              // with how long each file was seen, day by day
    } status;

    struct Log {
        log::Level level = log::Level::info;
    } log;

    struct Metrics {
        std::string file;  // for a node exporter; empty: none
    } metrics;

    struct Analyzer {
        int children = 0;  // 0: one for every two cores
        std::chrono::seconds deadline{120};
        double deadline_per_mebibyte = 2;  // seconds for each MiB of the file
        int memory = 2048;                 // MiB that one child may allocate
        std::chrono::seconds rescan{60};
        std::chrono::milliseconds quiet{2000};
        int frame_size = 320;  // px, longest side of an analysed frame
        double samples_per_second = 5;
        double motion_weight = 0.5;
        double image_weight = 0.5;
        double face_weight = 0;  // image saliency includes faces already
        SaliencyMethod saliency = SaliencyMethod::network;
        std::string saliency_model = "/usr/share/vitrine/u2netp.onnx";      // empty: no network
        std::string student_model = "/usr/share/vitrine/student.onnx";      // empty: no student
        std::string text_model = "/usr/share/vitrine/text_detection.onnx";  // empty: lines are not found
        std::string face_model = "/usr/share/vitrine/face_detection_yunet.onnx";  // empty: the cascade
        std::string face_cascade = "/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml";
        RegionMode region = RegionMode::min_area;
        double region_mass = 0.64;
        double region_margin = 0.008;  // share of the picture's diagonal
    } analyzer;

    struct Layout {
        int slots = 12;
        int seed = 1;
        EnergyMode energy = EnergyMode::screen;
        LayoutOrder order = LayoutOrder::free;
        NeighbourChoice neighbours = NeighbourChoice::any;
        double max_enlargement = 1.5;  // canvas px per source px
        double clearance = 2;          // canvas px between two I-Regions
        CellMethod cells = CellMethod::taut;
        double sample_spacing = 10;  // canvas px between sampled sites
        WallLook look = WallLook::seamless;
        double gutter = -1;         // canvas px between two cells; negative: as the look has it
        double corner_radius = -1;  // canvas px; negative: as the look has it
        double feather = -1;        // canvas px; negative: as the look has it
        WallMode mode = WallMode::fit;
        FolderMode folders = FolderMode::flat;
    } layout;

    struct Show {
        ShotOrder order = ShotOrder::shuffle;
        CaptionChoice captions = CaptionChoice::written;
        FilmShow film = FilmShow::automatic;
        std::chrono::seconds dwell{20};
        std::chrono::seconds longest{60};
        std::chrono::milliseconds motion{800};
        bool calm = false;         // nothing moves, and changes are rare
        bool photo_drift = false;  // photos move slowly inside their cells
        double pan_speed = 30;     // canvas px a second
        std::string background = "#101014";
        std::string holidays;       // dates_named()
        std::string qr;             // the text of a QR code for the whole wall; empty: none
        std::string share_address;  // where files are dropped, for the idle picture; empty: it does not tell
        bool on_this_day = false;   // files taken on this day in other years come first
    } show;

    struct Input {
        std::string devices = "auto";   // auto, none, or device nodes separated by commas
        std::chrono::seconds idle{30};  // time without a touch until the wall returns to normal
        std::chrono::seconds hint{
            0};  // time without a touch until shots show that they can be touched; 0: never
        bool keep_arrangement = false;  // a restart finds the wall as it was
        bool edit_keyframes = false;    // touches on a tapestry choose its keyframes
    } input;

    struct Output {
        std::string screen = "kms";      // a kind of display with its argument; setting_keys.cpp has all
        std::string mode;                // modes_named()
        int rotation = 0;                // degrees clockwise: 0, 90, 180 or 270
        std::string margins;             // margins_named()
        std::string folders;             // output_folders_named()
        std::string canvas;              // canvas_named(); empty: each output shows the whole wall
        std::string on;                  // day_windows_named(); empty: always
        std::chrono::minutes awake{10};  // after a touch outside these hours
        std::string dim;                 // dim_windows_named(); empty: never
        int frame_rate = 30;
        DecoderChoice decoders = DecoderChoice::automatic;
        KmsApi api = KmsApi::best;
        std::string sound = "default";  // a device of ALSA; empty: silent
    } output;

    struct Wall {
        WallRole role = WallRole::alone;
        std::string name;    // of the wall, is_wall_name()
        std::string box;     // of this box, is_wall_name(); empty: the host's name
        std::string leader;  // host name or address; a follower's
        std::string key = "/etc/vitrine/wall.key";
        std::string socket = "/run/vitrine-link/link.sock";
        std::string fetch_fault = "/run/vitrine-wall-fetch/fault";
    } wall;
};

}  // namespace vitrine
