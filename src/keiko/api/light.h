/// Points in, illuminance out; eyes in, what they see in fog out.
#pragma once

#include "keiko/stream/light_points.h"
#include "keiko/stream/sight_points.h"
