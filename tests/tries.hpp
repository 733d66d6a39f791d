#pragma once

#include <cstdlib>

namespace vitrine {

/// How often a test tries something: a sample, or all of it where VITRINE_ALL is set, as tests with the label
/// `long` set it.
inline int tries(int sample, int all) {
    return std::getenv("VITRINE_ALL") != nullptr ? all : sample;
}

}  // namespace vitrine
