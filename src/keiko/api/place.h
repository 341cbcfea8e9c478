/// Lamps placed by what a body mirrors.
#pragma once

#include "keiko/files/scene/rig_file.h"
#include "keiko/scene/criteria_preset.h"
#include "keiko/workflow/place_scene.h"
#include "keiko/workflow/write_placement.h"
