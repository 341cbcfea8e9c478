/// Models and scene files, prepared for use.
#pragma once

#include "keiko/base/text.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/light/rig/hidden_lamps.h"
#include "keiko/light/rig/luminaire_remarks.h"
#include "keiko/scene/view.h"
#include "keiko/workflow/analysis_file.h"
#include "keiko/workflow/choose_views.h"
#include "keiko/workflow/open_scene.h"
