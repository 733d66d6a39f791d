#include "analyzer/tapestry/weave/candidates.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "base/system/error.hpp"

#include <opencv2/imgproc.hpp>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace vitrine::analyzer {

namespace {

constexpr std::int64_t max_entries = 20'000;
constexpr std::int64_t max_jpeg_bytes = 1 << 20;
constexpr int max_brick_side = 4096;  // px
constexpr double enlargement = 2;     // bricks are small for detectors

void require(bool is_so) {
    if (!is_so) throw std::runtime_error("it is not a file of a film's frames");
}

}  // namespace

Candidates::Candidates(UniqueFd file, FaceDetector* faces) : file_(std::move(file)), detector_(faces) {
    const off_t size = ::lseek(file_.get(), 0, SEEK_END);
    if (size < 0) throw_errno("look at a file of frames");
    CandidateFileEnd end;
    require(size >= static_cast<off_t>(sizeof end));
    const std::int64_t end_offset = size - static_cast<std::int64_t>(sizeof end);
    read(&end, sizeof end, end_offset);
    require(end.mark == CandidateFileEnd::usual_mark && end.entries > 0 && end.entries <= max_entries);
    require(end.entries_offset >= 0 && end.entries_offset <= end_offset);
    require(end_offset - end.entries_offset == end.entries * std::int64_t{sizeof(CandidateEntry)});
    require(end.brick_width > 0 && end.brick_width <= max_brick_side && end.brick_height > 0 &&
            end.brick_height <= max_brick_side);
    brick_ = {end.brick_width, end.brick_height};
    duration_ = std::chrono::nanoseconds(end.duration_ns);
    content_ = end.content;
    for (std::int64_t i = 0; i < end.entries; ++i) {
        CandidateEntry entry;
        read(&entry, sizeof entry, end.entries_offset + i * std::int64_t{sizeof entry});
        require(entry.offset >= 0 && entry.bytes > 0 && entry.bytes <= max_jpeg_bytes);
        require(signatures_.empty() || entry.time_ns > signatures_.back().time.count());
        signatures_.push_back({.time = std::chrono::nanoseconds(entry.time_ns), .pixels = entry.signature});
        kept_.push_back({.offset = entry.offset, .bytes = entry.bytes});
    }
    faces_.resize(kept_.size());
}

void Candidates::read(void* into, std::size_t bytes, std::int64_t offset) const {
    const ssize_t got = ::pread(file_.get(), into, bytes, offset);
    if (got < 0) throw_errno("read a frame");
    if (static_cast<std::size_t>(got) != bytes)
        throw std::system_error(EIO, std::generic_category(), "read a frame");
}

Keyframe Candidates::keyframe(int number) const {
    const Kept& kept = kept_[as_index(number)];
    std::string jpeg(static_cast<std::size_t>(kept.bytes), '\0');
    read(jpeg.data(), jpeg.size(), kept.offset);
    Keyframe keyframe{.picture = from_jpeg(jpeg), .faces = {}};
    if (keyframe.picture.size() != brick_) throw std::runtime_error("a kept frame has another size");
    auto& faces = faces_[as_index(number)];
    if (!faces) faces = faces_in(keyframe.picture);
    keyframe.faces = *faces;
    return keyframe;
}

std::vector<cv::Rect> Candidates::faces_in(const cv::Mat& picture) const {
    std::vector<cv::Rect> faces;
    if (detector_ == nullptr) return faces;
    cv::Mat large;
    cv::resize(picture, large, {}, enlargement, enlargement, cv::INTER_CUBIC);
    for (const Face& face : detector_->detect(large)) {
        const cv::Point2d corner(face.box.min.x / enlargement, face.box.min.y / enlargement);
        const cv::Point2d other(face.box.max.x / enlargement, face.box.max.y / enlargement);
        const cv::Rect seen = cv::Rect(cv::Point(corner), cv::Point(other)) & cv::Rect({}, brick_);
        if (!seen.empty()) faces.push_back(seen);
    }
    return faces;
}

}  // namespace vitrine::analyzer
