#pragma once

#include "keiko/import/subdivision/cage.h"

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

namespace keiko::subdivision {

namespace osd = OpenSubdiv;

/// The cage's faces, tags and rules as OpenSubdiv sees them. Throws Error, without a file, when
/// OpenSubdiv refuses them.
std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const Cage& cage);

} // namespace keiko::subdivision
