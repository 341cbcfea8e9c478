#include "keiko/io/cad/face_check.h"

#include "keiko/io/cad/failure.h"

#include <BRepCheck_Analyzer.hxx>

namespace keiko::cad {

std::string fault_of(const TopoDS_Face& face) {
    try {
        return BRepCheck_Analyzer(face).IsValid() ? ""
                                                  : "invalid in the file, says OpenCASCADE's check";
    } catch (...) {
        return "could not be checked: " + current_failure();
    }
}

} // namespace keiko::cad
