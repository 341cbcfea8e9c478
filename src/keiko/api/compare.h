/// Two revisions of a part.
#pragma once

#include "keiko/workflow/compare_bodies.h"
