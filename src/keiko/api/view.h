/// Surfaces of a view, for lamps that are moved without tracing.
#pragma once

#include "keiko/files/scene/view_request.h"
#include "keiko/report/content/view_facts.h"
#include "keiko/workflow/deep_view.h"
