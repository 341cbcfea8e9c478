/// Lamps placed by the reflections of a body.
#pragma once

#include "keiko/files/scene/rig_file.h"
#include "keiko/scene/criteria_preset.h"
#include "keiko/workflow/place_scene.h"
