#include "analyzer/tapestry/weave/kept_frames.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/error.hpp"
#include "base/system/log.hpp"

#include <fcntl.h>

#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

fs::path file_in(const fs::path& directory) {
    return directory / "frames";
}

UniqueFd new_file(const fs::path& directory) {
    fs::create_directories(directory);
    const fs::path file = unfinished(file_in(directory));
    UniqueFd made(::open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!made.is_open()) throw_errno("open '{}'", file.string());
    return made;
}

}  // namespace

KeptFrames::KeptFrames(fs::path directory, std::uint64_t max_bytes, int brick_height)
    : directory_(std::move(directory)), max_bytes_(max_bytes) {
    try {
        writer_ =
            std::make_unique<CandidateWriter>(new_file(directory_), CandidateWriter::two_hours, brick_height);
    } catch (const std::system_error& error) {
        log::debug("no frames kept: {}", error.what());
    }
}

KeptFrames::~KeptFrames() {
    if (writer_) give_up();
}

void KeptFrames::give_up() {
    writer_.reset();
    std::error_code ignored;  // nobody reads an unfinished file
    fs::remove(unfinished(file_in(directory_)), ignored);
}

void KeptFrames::saw(const FilmFrame& frame) {
    if (!writer_) return;
    try {
        writer_->push(frame);
        if (writer_->bytes() > max_bytes_) give_up();
    } catch (const std::runtime_error& error) {  // no room, or no JPEG of the picture
        log::debug("no frames kept: {}", error.what());
        give_up();
    }
}

void KeptFrames::finish(const MediaRecord& film, const FilmContent& content,
                        const std::optional<cv::Rect>& active) {
    if (!writer_) return;
    if (writer_->is_empty()) return give_up();
    try {
        (void)writer_->finish(film, content, active);
        writer_.reset();
        publish_file(unfinished(file_in(directory_)), file_in(directory_));
    } catch (const std::system_error& error) {
        log::debug("no frames kept: {}", error.what());
        give_up();
    }
}

std::optional<UniqueFd> kept_frames(const fs::path& directory) {
    UniqueFd file(::open(file_in(directory).c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) return std::nullopt;
    return file;
}

void remove_kept_frames(const fs::path& directory) {
    std::error_code missing;
    fs::remove(file_in(directory), missing);
}

}  // namespace vitrine::analyzer
