#pragma once

#include "tests/bench/results.h"
#include "tests/bench/table.h"

namespace keiko::bench {

/// Table of what each contender cost to make.
Table cost_table(const SceneResult& scene);
/// Rates and accuracy, class by class.
Table rate_table(const SceneResult& scene);
/// One row a scene: Keiko's rates in packets and the primary rays of OpenCASCADE and of two meshes.
Table summary_table(const TraceResults& results);
/// "hood: 3 faces, 96 patches, 2410 mm"
std::string title_of(const SceneResult& scene);
/// Machine, compiler, date, rays and rounds in a line.
std::string conditions_of(const TraceResults& results);

} // namespace keiko::bench
