/// Rays in, hits out.
#pragma once

#include "keiko/stream/hit_columns.h"
#include "keiko/stream/trace_rays.h"
#include "keiko/stream/traced_rays.h"
