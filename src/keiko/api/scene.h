/// Models and scene files made ready.
#pragma once

#include "keiko/files/scene/material_file.h"
#include "keiko/light/rig/luminaire_remarks.h"
#include "keiko/scene/axes_remark.h"
#include "keiko/scene/suggestion.h"
#include "keiko/workflow/choose_views.h"
#include "keiko/workflow/open_scene.h"
