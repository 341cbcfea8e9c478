#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/triage/triage.h"

#include <string>

namespace keiko {

/// A fault in the words of the trade: "Kink (G1)". G0 to G2 are the orders of continuity that it
/// breaks.
std::string fault_title(const TriageItem& fault, const Inspection& inspection);

/// The message of a fault's worst finding; of a hole its size.
std::string message_of_worst(const Check& worst);

/// The third of a body's box in which a place lies: "rear right, high". x points to the rear, y to
/// the right and z up.
std::string words_of_place(const Vec3& place, const Box3& body);

/// "three-quarter front left" for "standing-three-quarter-front-left".
std::string words_of_view(const std::string& view);

/// A fault as an eye sees it: "mend the tangent · tears a stripe by up to 2.8′ (arc minutes), seen
/// from left · 271.5 mm on 3 seams · weight 12′". Of a bad patch also which face to rebuild, and of
/// a crease that ends before it has faded the angle that is left.
std::string sight_text(const TriageItem& fault, const Inspection& inspection);

/// The other findings of a fault, at most two of each seam or face: "also face 2 | face 47: gap of
/// 0.026 mm, kink of 0.52°". Of the seam or face that leads the fault its first finding is left
/// out. Of jumps too fine for an eye ten stretches at most, by falling radius. Empty without
/// anything else.
std::string also_text(const TriageItem& fault, const Inspection& inspection);

} // namespace keiko
