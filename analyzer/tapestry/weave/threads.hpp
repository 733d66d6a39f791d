#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"

namespace vitrine::analyzer {

/// Runs tasks on so many threads, the caller's among them; what a task throws is thrown to the caller, once
/// all have ended.
RunTasks threaded(int threads);

}  // namespace vitrine::analyzer
