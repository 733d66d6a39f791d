#pragma once

#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// The material that the tables measure on.
struct TableInput {
    std::filesystem::path media;    // a folder with ground truth in the format of ../shared/media
    std::filesystem::path masks{};  // a folder that masked_photos.py has made; "": none
    std::string face_model;         // YuNet's ONNX file; "": Viola-Jones
    std::string saliency_model;     // of the network that finds subjects of photos; "": none
    std::string student_model;      // of the small network that has learnt from it; "": none
    bool is_student = false;        // films are measured with the student
    std::string text_model;         // of the network that finds lines of text
    bool is_verbose = false;        // a line for each picture
};

/// Processor time of a look of each network, with the convolutions of OpenCV and with those of the tree.
void networks_table(const TableInput& input);

/// Transitions found, missed and false in edited films and films of one take.
void shots_table(const TableInput& input);

/// The share of a film's pictures that its shots show, and the longest stretch of one in which nothing moves.
void shown_table(const TableInput& input);

/// Marked subjects and faces of photographs inside the region, and what a picture costs.
void subjects_table(const TableInput& input);

/// Subjects of photographs with drawn masks inside the region, for half of them tuned on and half held back.
void masks_table(const TableInput& input);

/// Lines of text that lie whole in the region of slides and of photographs with signs.
void words_table(const TableInput& input);

/// Moving subjects inside the drifting region.
void motion_table(const TableInput& input);

/// The drift found on pictures that move by known velocities.
void drift_table(const TableInput& input);

/// Bars of films and photos found, and pictures wrongly cut.
void bars_table(const TableInput& input);

}  // namespace vitrine::analyzer
