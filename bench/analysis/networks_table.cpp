#include "analyzer/network/convolution_layer.hpp"
#include "analyzer/network/vectors.hpp"
#include "bench/analysis/cpu_time.hpp"
#include "bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <opencv2/dnn.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr int rounds = 7;

/// A network, and the input that its file declares or that it often gets.
struct Model {
    const char* name = nullptr;
    std::string file;
    cv::Size size;
};

/// Seconds of processor time of one look.
double look_at(cv::dnn::Net& net, const cv::Mat& input) {
    const double begin = cpu_seconds();
    net.setInput(input);
    std::vector<cv::Mat> outputs;
    net.forward(outputs, net.getUnconnectedOutLayersNames());
    return cpu_seconds() - begin;
}

double median(std::array<double, rounds> values) {
    std::ranges::sort(values);
    return values[rounds / 2];
}

void print_row(const Model& model, cv::dnn::Net& plain) {
    cv::dnn::Net fast = cv::dnn::readNetFromONNX(model.file);
    cv::Mat picture(model.size, CV_32FC3);
    cv::RNG random(5);
    random.fill(picture, cv::RNG::NORMAL, 0, 1);
    const cv::Mat input = cv::dnn::blobFromImage(picture);
    const double first_plain = look_at(plain, input);
    const double first_fast = look_at(fast, input);
    std::array<double, rounds> plain_looks{};
    std::array<double, rounds> fast_looks{};
    std::array<double, rounds> narrow_looks{};
    for (int i = 0; i < rounds; ++i) {
        plain_looks.at(static_cast<std::size_t>(i)) = look_at(plain, input);
        fast_looks.at(static_cast<std::size_t>(i)) = look_at(fast, input);
        turn_wide_vectors(false);
        narrow_looks.at(static_cast<std::size_t>(i)) = look_at(fast, input);
        turn_wide_vectors(true);
    }
    fmt::print("  {:16} {:4} x {:3} {:7.1f} {:7.1f} {:6.2f}   {:7.1f} {:7.1f} {:6.2f}   {:7.1f}\n",
               model.name, model.size.width, model.size.height, 1e3 * median(plain_looks),
               1e3 * median(fast_looks), median(plain_looks) / median(fast_looks), 1e3 * first_plain,
               1e3 * first_fast, first_plain / first_fast, 1e3 * median(narrow_looks));
}

}  // namespace

// A network keeps the convolutions that OpenCV had when it was read. So this table comes first: it reads the
// plain networks before any code calls use_fast_convolutions().
void networks_table(const TableInput& input) {
    fmt::print("networks: ms of processor time of a look by OpenCV, ours, ratio; the same of the first look; "
               "ours without AVX2\n");
    const std::array<Model, 4> models{{{"u2netp", input.saliency_model, {320, 320}},
                                       {"student", input.student_model, {160, 160}},
                                       {"lines of text", input.text_model, {640, 480}},
                                       {"YuNet", input.face_model, {640, 480}}}};
    std::vector<cv::dnn::Net> plain;
    for (const Model& model : models)
        plain.push_back(cv::dnn::readNetFromONNX(model.file));
    use_fast_convolutions();
    for (std::size_t i = 0; i < models.size(); ++i)
        print_row(models.at(i), plain[i]);
}

}  // namespace vitrine::analyzer
