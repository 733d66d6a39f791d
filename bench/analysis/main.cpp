// Measures the quality of the analysis on any folder with ground truth in the format of ../shared/media:
//   analysis_bench [--media FOLDER] [--faces YUNET.onnx] [--network MODEL.onnx] [--student MODEL.onnx]
//   [--masks FOLDER] [--only networks|shots|shown|subjects|masks|words|motion|drift|bars]
//   [--films-by-student]
//   [--verbose]

#include "bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <vips/vips.h>

#include <span>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

struct Table {
    const char* name;
    void (*print)(const TableInput&);
};

constexpr Table tables[] = {{"networks", networks_table}, {"shots", shots_table}, {"shown", shown_table},
                            {"subjects", subjects_table}, {"masks", masks_table}, {"words", words_table},
                            {"motion", motion_table},     {"drift", drift_table}, {"bars", bars_table}};

int usage() {
    fmt::print(
        "analysis_bench [--media FOLDER] [--faces YUNET.onnx] [--network MODEL.onnx] [--student MODEL.onnx] "
        "[--masks FOLDER] [--only networks|shots|shown|subjects|masks|words|motion|drift|bars] "
        "[--films-by-student] "
        "[--verbose]\n");
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    if (VIPS_INIT(argv[0]) != 0) return 1;
    cv::setNumThreads(1);
    TableInput input{.media = VITRINE_MEDIA,
                     .face_model = VITRINE_MODELS "/face_detection_yunet.onnx",
                     .saliency_model = VITRINE_MODELS "/u2netp.onnx",
                     .student_model = VITRINE_MODELS "/student.onnx",
                     .text_model = VITRINE_MODELS "/text_detection.onnx"};
    std::string only;
    const std::span<char*> words(argv, static_cast<std::size_t>(argc));
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string word = words[i];
        if (word == "--verbose") {
            input.is_verbose = true;
            continue;
        }
        if (word == "--films-by-student") {
            input.is_student = true;
            continue;
        }
        if (++i == words.size()) return usage();
        if (word == "--media")
            input.media = words[i];
        else if (word == "--faces")
            input.face_model = words[i];
        else if (word == "--network")
            input.saliency_model = words[i];
        else if (word == "--student")
            input.student_model = words[i];
        else if (word == "--masks")
            input.masks = words[i];
        else if (word == "--only")
            only = words[i];
        else
            return usage();
    }
    if (!std::filesystem::is_directory(input.media)) {
        fmt::print("the media with ground truth are not here: '{}'\n", input.media.string());
        return 0;
    }
    for (const Table& table : tables)
        if (only.empty() || only == table.name) table.print(input);
    return 0;
}
