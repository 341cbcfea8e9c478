/// Points in, illuminance out.
#pragma once

#include "keiko/stream/light_points.h"
