/// Results and findings of runs, and curves for other programs.
#pragma once

#include "keiko/import/worker/curve_files.h"
#include "keiko/report/content/curve_sets.h"
#include "keiko/workflow/earlier_results.h"
#include "keiko/workflow/version.h"
