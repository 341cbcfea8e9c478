/// Surfaces of a view, for lamps that are moved without tracing.
#pragma once

#include "keiko/files/scene/view_request.h"
#include "keiko/report/content/report_stretch.h"
#include "keiko/report/content/triaged_faults.h"
#include "keiko/report/content/view_facts.h"
#include "keiko/workflow/check_scene.h"
#include "keiko/workflow/deep_view.h"
#include "keiko/workflow/hidden_faces.h"
#include "keiko/workflow/pick_place.h"
#include "keiko/workflow/report_folder.h"
#include "keiko/workflow/scene_faults.h"
#include "keiko/workflow/view_analysis.h"
