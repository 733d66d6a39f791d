#include "analyzer/tapestry/weave/candidates.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/weave/candidate_writer.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "base/state/record_json.hpp"
#include "base/system/error.hpp"

#include <opencv2/imgproc.hpp>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace vitrine::analyzer {

namespace {

constexpr std::int64_t max_entries = 20'000;
constexpr std::int64_t max_jpeg_bytes = 32 << 20;  // of a frame of 4096 px, with room
constexpr std::int64_t max_record_bytes = 64 << 20;
constexpr double detected_height = 200;  // px to which small bricks are enlarged for detectors
constexpr double min_part = 0.55;  // of either side within a shot's own bars; less is a title on plain ground
constexpr double max_region = 0.6;  // of a brick: a larger region says nothing

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
    read_sizes(end);
    read_record(end);
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

void Candidates::read_sizes(const CandidateFileEnd& end) {
    const auto is_side = [](int px) { return px > 0 && px <= max_side; };
    require(is_side(end.brick_width) && is_side(end.brick_height));
    require(is_side(end.frame_width) && is_side(end.frame_height));
    const auto& [left, top, width, height] = end.active;
    require(is_side(width) && is_side(height));
    brick_ = {end.brick_width, end.brick_height};
    frame_ = {end.frame_width, end.frame_height};
    active_ = {left, top, width, height};
    require(left >= 0 && top >= 0 && (active_ & cv::Rect({0, 0}, frame_)) == active_);
}

void Candidates::read_record(const CandidateFileEnd& end) {
    require(end.record_bytes > 0 && end.record_bytes <= max_record_bytes &&
            end.record_bytes <= end.entries_offset);
    std::string text(static_cast<std::size_t>(end.record_bytes), '\0');
    read(text.data(), text.size(), end.entries_offset - end.record_bytes);
    film_ = record_from_json(text);
}

void Candidates::read(void* into, std::size_t bytes, std::int64_t offset) const {
    const ssize_t got = ::pread(file_.get(), into, bytes, offset);
    if (got < 0) throw_errno("read a frame");
    if (static_cast<std::size_t>(got) != bytes)
        throw std::system_error(EIO, std::generic_category(), "read a frame");
}

cv::Mat Candidates::kept_picture(int number) const {
    const Kept& kept = kept_[as_index(number)];
    std::string jpeg(static_cast<std::size_t>(kept.bytes), '\0');
    read(jpeg.data(), jpeg.size(), kept.offset);
    return from_jpeg(jpeg);
}

Candidates::KeptPart Candidates::kept_part(int number, cv::Size whole) const {
    const cv::Rect active = active_part(shot_at(number), whole);
    return {.whole = whole, .part = cut_to(active.size(), brick_) + active.tl()};
}

cv::Mat Candidates::as_brick(const cv::Mat& kept, const KeptPart& part) const {
    if (part.part.size() == brick_ && kept.size() == brick_) return kept;
    cv::Mat brick;
    cv::resize(kept(part.part), brick, brick_, 0, 0,
               part.part.height < brick_.height ? cv::INTER_CUBIC : cv::INTER_AREA);
    return brick;
}

cv::Mat Candidates::picture(int number) const {
    const cv::Mat whole = kept_picture(number);
    return as_brick(whole, kept_part(number, whole.size()));
}

Keyframe Candidates::keyframe(int number, FaceSearch search) const {
    const cv::Mat whole = kept_picture(number);
    const KeptPart part = kept_part(number, whole.size());
    Keyframe keyframe{.picture = as_brick(whole, part), .faces = {}, .region = {}};
    auto& faces = faces_[as_index(number)];
    if (!faces && search == FaceSearch::done) faces = faces_in(keyframe.picture);
    if (faces) keyframe.faces = *faces;
    if (const Shot* shot = shot_at(number); shot != nullptr) keyframe.region = region_in(*shot, number, part);
    return keyframe;
}

/// The shot that a frame lies in, null where it lies between shots.
const Shot* Candidates::shot_at(int number) const {
    const auto time = signatures_[as_index(number)].time;
    const auto after = std::ranges::upper_bound(film_.shots, time, {}, &Shot::begin);
    if (after == film_.shots.begin() || time >= (after - 1)->end) return nullptr;
    return &*(after - 1);
}

/// The part of a kept picture within the bars of the film and of the shot. A picture of the size of a brick
/// was kept when its bars were not known.
cv::Rect Candidates::active_part(const Shot* shot, cv::Size kept) const {
    if (kept != frame_ && kept != brick_for(frame_, brick_.height))
        throw std::runtime_error("a kept frame has another size");
    const auto part_within = [&](double left, double top, double right, double bottom) {
        const double x = static_cast<double>(kept.width) / frame_.width;
        const double y = static_cast<double>(kept.height) / frame_.height;
        return cv::Rect(cv::Point(cvCeil(left * x), cvCeil(top * y)),
                        cv::Point(cvFloor(right * x), cvFloor(bottom * y)));
    };
    cv::Rect part = part_within(active_.x, active_.y, active_.br().x, active_.br().y);
    if (shot != nullptr && shot->picture && film_.width > 0 && film_.height > 0) {
        const double x = static_cast<double>(frame_.width) / film_.width;
        const double y = static_cast<double>(frame_.height) / film_.height;
        const Box& picture = *shot->picture;
        const cv::Rect own =
            part & part_within(picture.min.x * x, picture.min.y * y, picture.max.x * x, picture.max.y * y);
        if (own.width >= min_part * part.width && own.height >= min_part * part.height) part = own;
    }
    if (part.empty()) throw std::runtime_error("a kept frame has no picture within its bars");
    return part;
}

/// The shot's region at the time of a frame, px of the brick.
std::vector<cv::Point> Candidates::region_in(const Shot& shot, int number, const KeptPart& part) const {
    if (shot.region.polygon.size() < 3 || film_.width <= 0 || film_.height <= 0) return {};
    const double seconds =
        std::chrono::duration<double>(signatures_[as_index(number)].time - shot.begin).count();
    const double x = static_cast<double>(part.whole.width) / film_.width;
    const double y = static_cast<double>(part.whole.height) / film_.height;
    const auto limits = Box{{0, 0}, {static_cast<double>(brick_.width), static_cast<double>(brick_.height)}};
    Polygon corners;
    for (const Vec2& corner : shot.region.polygon) {
        const Vec2 at = corner + shot.region.drift * seconds;
        corners.push_back({(at.x * x - part.part.x) * brick_.width / part.part.width,
                           (at.y * y - part.part.y) * brick_.height / part.part.height});
    }
    corners = clipped(corners, limits);
    if (area(corners) > max_region * limits.area()) return {};
    std::vector<cv::Point> region;
    for (const Vec2& corner : corners)
        region.emplace_back(cvRound(corner.x), cvRound(corner.y));
    return region;
}

std::vector<cv::Rect> Candidates::faces_in(const cv::Mat& picture) const {
    std::vector<cv::Rect> faces;
    if (detector_ == nullptr) return faces;
    const double enlargement = std::max(1.0, detected_height / brick_.height);
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
