#include "analyzer/tapestry/weave/candidate_writer.hpp"

#include "analyzer/tapestry/weave/picture_file.hpp"
#include "base/state/record_json.hpp"
#include "base/system/error.hpp"

#include <fcntl.h>
#include <opencv2/imgproc.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace vitrine::analyzer {

namespace {

// 2 frames a second; source: Video Tapestries 4.1
constexpr std::chrono::milliseconds min_interval{500};
constexpr double min_shape = 0.4;  // width to height
constexpr double max_shape = 3;
constexpr int jpeg_quality = 96;  // the tiles made of them have 90

CandidateEntry entry_of(const FilmFrame& frame) {
    cv::Mat small;
    cv::resize(frame.picture, small, {FrameSignature::width, FrameSignature::height}, 0, 0, cv::INTER_AREA);
    CandidateEntry entry{.time_ns = frame.time.count()};
    std::copy_n(small.ptr<std::uint8_t>(), entry.signature.size(), entry.signature.begin());
    return entry;
}

}  // namespace

cv::Size brick_for(cv::Size frame, int height) {
    const double shape = std::clamp(static_cast<double>(frame.width) / frame.height, min_shape, max_shape);
    return {2 * static_cast<int>(std::lround(height * shape / 2)), height};
}

cv::Rect cut_to(cv::Size picture, cv::Size brick) {
    const double scale = std::min(static_cast<double>(picture.width) / brick.width,
                                  static_cast<double>(picture.height) / brick.height);
    const cv::Size part(std::clamp(static_cast<int>(std::lround(brick.width * scale)), 1, picture.width),
                        std::clamp(static_cast<int>(std::lround(brick.height * scale)), 1, picture.height));
    return {{(picture.width - part.width) / 2, (picture.height - part.height) / 2}, part};
}

UniqueFd nameless_file(const std::filesystem::path& directory) {
    std::string name = (directory / "frames-XXXXXX").string();
    UniqueFd file(::mkostemp(name.data(), O_CLOEXEC));
    if (!file.is_open()) throw_errno("make a file in '{}'", directory.string());
    if (::unlink(name.c_str()) < 0) throw_errno("unlink '{}'", name);
    return file;
}

void CandidateWriter::append(const void* data, std::size_t bytes) {
    const ssize_t written = ::pwrite(file_.get(), data, bytes, written_);
    if (written < 0) throw_errno("write a frame");
    if (static_cast<std::size_t>(written) != bytes)
        throw std::system_error(ENOSPC, std::generic_category(), "write a frame");
    written_ += written;
}

void CandidateWriter::push(const FilmFrame& frame) {
    if (last_.count() < 0) {
        frame_ = frame.picture.size();
        interval_ = min_interval;
        due_ = frame.time;
    }
    if (frame.time <= last_ || frame.picture.size() != frame_) return;
    last_ = frame.time;
    if (frame.time < due_) return;
    due_ = frame.time + interval_;
    bars_.add_picture(frame.picture, frame.time);
    cv::Mat picture = frame.picture;
    if (bars_.newest() == bars_.whole()) {
        const cv::Size brick = brick_for(frame_, brick_height_);
        cv::resize(frame.picture(cut_to(frame_, brick)), picture, brick, 0, 0, cv::INTER_AREA);
    }
    const std::string jpeg = to_jpeg(picture, jpeg_quality);
    CandidateEntry entry = entry_of(frame);
    entry.offset = written_;
    entry.bytes = static_cast<std::int64_t>(jpeg.size());
    append(jpeg.data(), jpeg.size());
    entries_.push_back(entry);
    if (entries_.size() >= max_frames_) thin();
}

/// Drops every other frame. From now on frames are kept half as often.
void CandidateWriter::thin() {
    for (std::size_t i = 1; 2 * i < entries_.size(); ++i)
        entries_[i] = entries_[2 * i];
    entries_.resize((entries_.size() + 1) / 2);
    interval_ *= 2;
    due_ = std::chrono::nanoseconds(entries_.back().time_ns) + interval_;
}

UniqueFd CandidateWriter::finish(const MediaRecord& film, const FilmContent& content,
                                 const std::optional<cv::Rect>& known) {
    const std::string record = to_json(film);
    append(record.data(), record.size());
    const cv::Rect found = bars_.close_shot(std::chrono::nanoseconds(0), std::chrono::nanoseconds::max());
    const cv::Rect active = known.value_or(found);
    const cv::Size brick = brick_for(active.size(), brick_height_);
    const CandidateFileEnd end{
        .content = content,
        .duration_ns = std::max(film.duration, last_ + std::chrono::nanoseconds(1)).count(),
        .entries_offset = written_,
        .entries = static_cast<std::int64_t>(entries_.size()),
        .record_bytes = static_cast<std::int64_t>(record.size()),
        .brick_width = brick.width,
        .brick_height = brick.height,
        .frame_width = frame_.width,
        .frame_height = frame_.height,
        .active = {active.x, active.y, active.width, active.height},
    };
    append(entries_.data(), entries_.size() * sizeof(CandidateEntry));
    append(&end, sizeof end);
    return std::move(file_);
}

}  // namespace vitrine::analyzer
