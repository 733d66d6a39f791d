#pragma once

#include <stdexcept>

namespace vitrine {

/// A line or a message that breaks the rules of base/wall. Its text is a sentence for the log.
struct BrokenLine : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace vitrine
