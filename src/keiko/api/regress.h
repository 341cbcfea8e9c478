/// Suites of fixtures and their baselines; runs that are divided among machines.
#pragma once

#include "keiko/batch/run_parts.h"
#include "keiko/regress/regress.h"
