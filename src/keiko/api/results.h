/// Results and findings of runs.
#pragma once

#include "keiko/workflow/earlier_results.h"
#include "keiko/workflow/version.h"
