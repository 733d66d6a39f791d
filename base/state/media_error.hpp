#pragma once

#include "base/state/record.hpp"

#include <stdexcept>
#include <string>

namespace vitrine {

/// A file cannot be shown. Holds the state for its record, and the reason in the operator's words without the
/// file's name ("the copy is not complete: half of the picture is missing").
class MediaError : public std::runtime_error {
  public:
    MediaError(MediaState state, const std::string& reason) : std::runtime_error(reason), state_(state) {}

    MediaState state() const { return state_; }

  private:
    MediaState state_;
};

}  // namespace vitrine
