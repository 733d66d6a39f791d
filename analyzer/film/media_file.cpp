#include "analyzer/film/media_file.hpp"

#include "base/state/record.hpp"
#include "base/system/error.hpp"
#include "base/system/hold_below.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

/// @param path  as record_path() has it
UniqueFd held(const fs::path& file, const fs::path& root, const std::string& path) {
    const bool is_inside =
        (fs::absolute(root) / path).lexically_normal() == fs::absolute(file).lexically_normal();
    if (is_inside && fs::path(path).is_relative()) return hold_below(root, path);
    UniqueFd found(::open(file.c_str(), O_PATH | O_CLOEXEC));
    if (!found.is_open()) throw_errno("look at '{}'", file.string());
    return found;
}

}  // namespace

MediaFile::MediaFile(const fs::path& file, const fs::path& root)
    : path_(record_path(file, root)), held_(held(file, root, path_)) {
    struct stat status {};

    if (::fstat(held_.get(), &status) < 0) throw_errno("look at '{}'", file.string());
    bytes_ = static_cast<std::uint64_t>(status.st_size);
    mtime_ns_ = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
    is_plain_ = S_ISREG(status.st_mode);
}

std::string MediaFile::name() const {
    return fmt::format("/proc/self/fd/{}", held_.get());
}

}  // namespace vitrine::analyzer
