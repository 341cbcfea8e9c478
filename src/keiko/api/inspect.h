/// The whole inspection of a body.
#pragma once

#include "keiko/report/json/report_json.h"
#include "keiko/workflow/inspect_scene.h"
