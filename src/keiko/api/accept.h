/// Findings that a person accepts.
#pragma once

#include "keiko/report/content/acceptance_texts.h"
#include "keiko/workflow/accepted_findings.h"
