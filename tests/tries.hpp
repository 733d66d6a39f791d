#pragma once

#include <cstdlib>

namespace vitrine {

/// Returns how many of its cases a test tries. Unit tests try a sample. Tests with the label `long` set
/// VITRINE_ALL and try all of them.
inline int tries(int sample, int all) {
    return std::getenv("VITRINE_ALL") != nullptr ? all : sample;
}

}  // namespace vitrine
