#pragma once

#include "keiko/base/error.h"
#include "keiko/math/affine.h"
#include "keiko/math/rgb.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keiko::cad {

/// Attributes that a file gives a face besides its geometry.
struct FaceAttributes {
    std::string name, layer;
    std::optional<Rgb> color;
    std::uint32_t line = 0; ///< as Face::line
};

/// A shape that is stored once in the file.
struct CadPart {
    TopoDS_Shape shape;
    std::string name;
    std::function<FaceAttributes(const TopoDS_Shape& face)> attributes_of; ///< may be empty
    std::function<std::vector<std::string>(const TopoDS_Shape& face)>
        remarks_on{}; ///< may be empty
};

/// A placed part.
struct CadInstance {
    std::size_t part = 0;
    std::string name;
    Affine transform;
};

/// A CAD file as OpenCASCADE read it, in millimetres, before any conversion.
struct CadDocument {
    std::string unit; ///< of the file, as units.h knows it; empty where it names none
    std::vector<CadPart> parts;
    std::vector<CadInstance> instances;
    std::vector<std::string>
        missing_files; ///< which the file names for parts, but which are not there
    Diagnostics diagnostics;
};

/// Each reads one kind of file. Throws Error naming the file when it cannot be read.
CadDocument read_step_file(const std::filesystem::path& path);
CadDocument read_iges_file(const std::filesystem::path& path);
CadDocument read_brep_file(const std::filesystem::path& path);

} // namespace keiko::cad
