/// Lines of the lamps on a body, line drawings of it, and files of curves.
#pragma once

#include "keiko/files/scene/rig_file.h"
#include "keiko/film/image_file.h"
#include "keiko/geometry/model/curve_fault.h"
#include "keiko/import/worker/curve_files.h"
#include "keiko/report/content/contour_set.h"
#include "keiko/report/content/line_list.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/workflow/curve_output.h"
#include "keiko/workflow/draw_scene.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/found_curves.h"
