/// The whole inspection of a body.
#pragma once

#include "keiko/report/content/report.h"
#include "keiko/workflow/inspect_scene.h"
