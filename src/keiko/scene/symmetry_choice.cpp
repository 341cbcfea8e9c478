#include "keiko/scene/symmetry_choice.h"

namespace keiko {

SymmetryChoice SymmetryChoice::parse(std::string_view text) {
    SymmetryChoice choice;
    if (text == "off") return choice;
    choice.kind = text == "auto" ? Kind::automatic : Kind::plane;
    if (choice.kind == Kind::plane) choice.plane = MirrorPlane::parse(text);
    return choice;
}

} // namespace keiko
