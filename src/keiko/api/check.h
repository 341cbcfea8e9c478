/// Geometry judged by criteria.
#pragma once

#include "keiko/report/content/line_checks.h"
#include "keiko/report/content/unmet_borders.h"
#include "keiko/report/csv/checks_csv.h"
#include "keiko/report/json/report_json.h"
#include "keiko/report/junit/junit.h"
#include "keiko/report/sarif/sarif.h"
#include "keiko/report/text/inspection_text.h"
#include "keiko/workflow/check_models.h"
