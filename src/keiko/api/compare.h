/// Two revisions of a part, a part and its scan, or a part and its meshes.
#pragma once

#include "keiko/workflow/compare_bodies.h"
#include "keiko/workflow/compare_scan.h"
#include "keiko/workflow/mesh_error.h"
