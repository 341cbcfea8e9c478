/// Suites of fixtures and their baselines.
#pragma once

#include "keiko/regress/regress.h"
