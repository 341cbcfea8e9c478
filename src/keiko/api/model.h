/// Models as values, contents of a model or luminaire file, and bodies in triangles.
#pragma once

#include "keiko/files/model/model_serialization.h"
#include "keiko/files/photometric/luminaire_file.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/light/rig/luminaire_remarks.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/luminaire_facts.h"
#include "keiko/report/content/mesh_files.h"
#include "keiko/workflow/build_facts.h"
#include "keiko/workflow/check_models.h"
#include "keiko/workflow/surface_mesh.h"
#include "keiko/workflow/version.h"
