#include "analyzer/weave/candidates.hpp"

#include "base/system/error.hpp"

#include <fcntl.h>
#include <opencv2/imgproc.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace vitrine {

namespace {

constexpr std::chrono::milliseconds shortest_interval{
    500};                                        // 2 frames a second; source: Video Tapestries 4.1
constexpr std::size_t most_candidates = 14'400;  // two hours of them
constexpr int brick_height = 100;                // px: a tapestry of 150
constexpr double least_shape = 0.4;              // width to height
constexpr double most_shape = 3;

UniqueFd nameless_file(const std::filesystem::path& directory) {
    std::string name = (directory / "frames-XXXXXX").string();
    UniqueFd file(::mkostemp(name.data(), O_CLOEXEC));
    if (!file.is_open()) throw_errno("make a file in '{}'", directory.string());
    if (::unlink(name.c_str()) < 0) throw_errno("unlink '{}'", name);
    return file;
}

/// The middle of a frame that has the shape of a brick.
cv::Rect cut_to(cv::Size frame, cv::Size brick) {
    const double scale = std::min(static_cast<double>(frame.width) / brick.width,
                                  static_cast<double>(frame.height) / brick.height);
    const cv::Size part(std::clamp(static_cast<int>(std::lround(brick.width * scale)), 1, frame.width),
                        std::clamp(static_cast<int>(std::lround(brick.height * scale)), 1, frame.height));
    return {{(frame.width - part.width) / 2, (frame.height - part.height) / 2}, part};
}

FrameSignature signature_of(const VideoFrame& frame) {
    cv::Mat small;
    cv::resize(frame.picture, small, {FrameSignature::width, FrameSignature::height}, 0, 0, cv::INTER_AREA);
    FrameSignature signature{.time = frame.time};
    std::copy_n(small.ptr<std::uint8_t>(), signature.pixels.size(), signature.pixels.begin());
    return signature;
}

}  // namespace

cv::Size brick_for(cv::Size frame) {
    const double shape = std::clamp(static_cast<double>(frame.width) / frame.height, least_shape, most_shape);
    return {2 * static_cast<int>(std::lround(brick_height * shape / 2)), brick_height};
}

Candidates::Candidates(cv::Size brick, const std::filesystem::path& directory, FaceDetector* faces)
    : brick_(brick), file_(nameless_file(directory)), detector_(faces), interval_(shortest_interval) {}

void Candidates::push(const VideoFrame& frame) {
    if (!kept_.empty() && frame.time < due_) return;
    due_ = frame.time + interval_;
    const cv::Rect part = cut_to(frame.picture.size(), brick_);
    cv::Mat picture;
    cv::resize(frame.picture(part), picture, brick_, 0, 0, cv::INTER_AREA);
    const std::size_t bytes = picture.total() * picture.elemSize();
    const auto offset = static_cast<off_t>(slots_ * static_cast<std::int64_t>(bytes));
    const ssize_t written = ::pwrite(file_.get(), picture.data, bytes, offset);
    if (written < 0) throw_errno("write a frame");
    if (static_cast<std::size_t>(written) != bytes)
        throw std::system_error(ENOSPC, std::generic_category(), "write a frame");
    Kept kept{.slot = slots_++, .faces = {}};
    if (detector_ != nullptr) {
        const double scale = static_cast<double>(brick_.width) / part.width;
        for (const Face& face : detector_->detect(frame.picture)) {
            const Box box = moved(face.box, {-1.0 * part.x, -1.0 * part.y});
            const cv::Point2d corner(box.min.x * scale, box.min.y * scale);
            const cv::Point2d other(box.max.x * scale, box.max.y * scale);
            const cv::Rect seen = cv::Rect(cv::Point(corner), cv::Point(other)) & cv::Rect({}, brick_);
            if (!seen.empty()) kept.faces.push_back(seen);
        }
    }
    kept_.push_back(std::move(kept));
    signatures_.push_back(signature_of(frame));
    if (kept_.size() >= most_candidates) thin();
}

/// Every other one goes, and from now on they come half as often.
void Candidates::thin() {
    for (std::size_t i = 1; 2 * i < kept_.size(); ++i) {
        kept_[i] = std::move(kept_[2 * i]);
        signatures_[i] = signatures_[2 * i];
    }
    kept_.resize((kept_.size() + 1) / 2);
    signatures_.resize(kept_.size());
    interval_ *= 2;
    due_ = signatures_.back().time + interval_;
}

Keyframe Candidates::keyframe(int number) const {
    const Kept& kept = kept_[static_cast<std::size_t>(number)];
    Keyframe keyframe{.picture = cv::Mat(brick_, CV_8UC3), .faces = kept.faces};
    const std::size_t bytes = keyframe.picture.total() * keyframe.picture.elemSize();
    const ssize_t got = ::pread(file_.get(), keyframe.picture.data, bytes,
                                static_cast<off_t>(kept.slot * static_cast<std::int64_t>(bytes)));
    if (got < 0) throw_errno("read a frame");
    if (static_cast<std::size_t>(got) != bytes)
        throw std::system_error(EIO, std::generic_category(), "read a frame");
    return keyframe;
}

}  // namespace vitrine
