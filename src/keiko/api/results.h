/// What runs leave and find.
#pragma once

#include "keiko/workflow/earlier_results.h"
#include "keiko/workflow/input_key.h"
