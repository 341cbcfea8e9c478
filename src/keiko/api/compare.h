/// Two revisions of a part, or a part and its scan.
#pragma once

#include "keiko/workflow/compare_bodies.h"
#include "keiko/workflow/compare_scan.h"
