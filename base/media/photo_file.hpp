#pragma once

#include "base/media/file_bytes.hpp"
#include "base/state/media_error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <span>
#include <string>

namespace vitrine {

/// The file of a photo, as the libraries that decode it read it: by call-backs that may not throw. A library
/// would map the file into memory, where a fault of the share is a SIGBUS, or read on after a fault as if the
/// file ended there.
class PhotoFile {
  public:
    /// @throws MediaError if the file cannot be opened
    explicit PhotoFile(const std::string& path) : bytes_(path) {}

    std::int64_t size() const { return static_cast<std::int64_t>(bytes_.size()); }

    std::int64_t position() const { return at_; }

    /// Reads the next bytes. @return how many; 0 at the end, -1 at a fault
    std::int64_t read(std::span<std::byte> to) {
        try {
            const std::size_t got = bytes_.read(static_cast<std::uint64_t>(at_), to);
            at_ += static_cast<std::int64_t>(got);
            return static_cast<std::int64_t>(got);
        } catch (...) {
            fault_ = std::current_exception();
            return -1;
        }
    }

    /// @param whence  SEEK_SET, SEEK_CUR or SEEK_END
    /// @return the new position; -1 where that would be before the first byte
    std::int64_t seek(std::int64_t offset, int whence = SEEK_SET) {
        const std::int64_t base = whence == SEEK_SET ? 0 : whence == SEEK_END ? size() : at_;
        if (offset < -base) return -1;
        return at_ = base + offset;
    }

    /// Throws the fault that a reading met, if one did.
    void throw_fault() const {
        if (fault_) std::rethrow_exception(fault_);
    }

  private:
    FileBytes bytes_;
    std::int64_t at_ = 0;
    std::exception_ptr fault_;
};

}  // namespace vitrine
