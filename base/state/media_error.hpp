#pragma once

#include "base/state/fault.hpp"
#include "base/state/record.hpp"

#include <stdexcept>
#include <string>

namespace vitrine {

/// A file cannot be shown. Holds the state for its record, and the reason in the operator's words without the
/// file's name ("the copy is not complete: half of the picture is missing").
class MediaError : public std::runtime_error {
  public:
    /// A fault of the file.
    MediaError(MediaState state, const std::string& reason) : std::runtime_error(reason), state_(state) {}

    /// A fault of somebody else: the file waits until it is over.
    MediaError(FaultOwner owner, const std::string& reason)
        : std::runtime_error(reason), state_(MediaState::waiting), owner_(owner) {}

    MediaState state() const { return state_; }

    FaultOwner owner() const { return owner_; }

  private:
    MediaState state_;
    FaultOwner owner_ = FaultOwner::file;
};

/// The error for a call on a media file that failed.
/// @param what   "the file cannot be opened"
/// @param error  errno
MediaError failed_call(const std::string& what, int error);

}  // namespace vitrine
