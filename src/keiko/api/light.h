/// Points in, illuminance out; eyes in, what they see in fog out; light that surfaces reflect.
#pragma once

#include "keiko/radiosity/solution_file.h"
#include "keiko/stream/light_points.h"
#include "keiko/stream/sight_points.h"
#include "keiko/workflow/solve_radiosity.h"
