#pragma once

#include "base/system/unique_fd.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace vitrine::analyzer {

/// One file of media: its identity, read once. The file is held, so whatever takes its name later is not read
/// in its place.
class MediaFile {
  public:
    /// Does not open the file. Below `root` no link is followed; a person may name a file elsewhere by a
    /// link.
    /// @throws std::system_error where there is no such file
    MediaFile(const std::filesystem::path& file, const std::filesystem::path& root);

    /// Its path as its record has it: relative to `root` where it lies there.
    const std::string& path() const { return path_; }

    /// The name by which it is opened: "/proc/self/fd/N". Not for words.
    std::string name() const;

    /// Held by this object; without the right to read.
    int descriptor() const { return held_.get(); }

    std::uint64_t bytes() const { return bytes_; }

    std::int64_t mtime_ns() const { return mtime_ns_; }

    /// False for folders and devices.
    bool is_plain() const { return is_plain_; }

  private:
    std::string path_;
    UniqueFd held_;
    std::uint64_t bytes_ = 0;
    std::int64_t mtime_ns_ = 0;
    bool is_plain_ = false;
};

}  // namespace vitrine::analyzer
