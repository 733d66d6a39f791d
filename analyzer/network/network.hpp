#pragma once

#include <opencv2/dnn.hpp>

#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The input of a network that was trained with ImageNet's means and deviations, which are those of red,
/// green and blue.
/// @param picture  CV_8UC3; its first channel gets the first mean, and so on
cv::Mat network_input(const cv::Mat& picture);

/// A neural network that makes one map of a picture. OpenCV 4.6 computes nonsense after a change of size, so
/// each size has a net of its own, of which the last two are kept.
class Network {
  public:
    /// @param name   for errors: what it is, and its file
    /// @param model  ONNX
    /// @throws std::runtime_error if OpenCV cannot use a model that declares no square input
    Network(std::string name, std::string model);

    /// True if the model declares its input as a square of 320 or 160 px. It is prepared for any other size
    /// all the same.
    bool declares_square() const { return declared_ > 0; }

    /// The first look at a picture of another size also prepares the model.
    /// @param input  as of network_input()
    /// @return       the first output, CV_32FC1
    /// @throws std::runtime_error if OpenCV cannot use the model, or it gives no map of such a picture
    cv::Mat map(const cv::Mat& input);

  private:
    struct SizedNet {
        cv::dnn::Net net;
        std::string output;  // name of the first
        cv::Size size;       // of its input so far; empty: it has had none
    };

    SizedNet prepared(cv::Size size) const;
    SizedNet& net_for(cv::Size size);

    std::string name_;
    std::string model_;
    int declared_ = 0;  // px, side of the declared square; 0: none that is known
    std::vector<SizedNet> nets_;
};

}  // namespace vitrine::analyzer
