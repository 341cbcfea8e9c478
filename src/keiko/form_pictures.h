#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/keiko.h"

namespace keiko {

/// One view of a body by other looks than its lamps', from a film that has look_layers: the
/// Gaussian curvature with what the eye sees of the inflection curves, and zebra.
std::vector<ReportPicture> form_pictures(const NamedView& view, const Film& film,
                                         const Inspection& inspection, const LightRig& rig);

} // namespace keiko
