#pragma once

#include "player/layout/plan/flat_plan.hpp"
