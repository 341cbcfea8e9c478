/// Geometry judged by criteria.
#pragma once

#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/line_list.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/workflow/check_models.h"
