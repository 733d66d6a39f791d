#pragma once

#include "analyzer/tapestry/run_tasks.hpp"

namespace vitrine {

/// Runs tasks on so many threads, the caller's among them; what a task throws is thrown to the caller, once
/// all have ended.
RunTasks threaded(int threads);

}  // namespace vitrine
