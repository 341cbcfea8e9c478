/// Pictures of a scene.
#pragma once

#include "keiko/files/scene/rig_file.h"
#include "keiko/film/false_color.h"
#include "keiko/film/image_file.h"
#include "keiko/render/panorama_film.h"
#include "keiko/render/shading/picture.h"
#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/hidden_faces.h"
#include "keiko/workflow/mesh_picture.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/render_stereo.h"
#include "keiko/workflow/scene_analysis.h"
#include "keiko/workflow/section_curvature.h"
