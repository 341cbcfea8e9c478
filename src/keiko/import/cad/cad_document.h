#pragma once

#include "keiko/base/error.h"
#include "keiko/math/affine.h"
#include "keiko/math/rgb.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace keiko::cad {

/// Attributes that a file gives a face besides its geometry.
struct FaceAttributes {
    std::string name, layer;  ///< or empty
    std::optional<Rgb> color; ///< parts 0 to 1, as OpenCASCADE states them; nullopt: none
    std::uint32_t line = 0;   ///< as Face::line
};

/// A shape that is stored once in the file.
struct CadPart {
    TopoDS_Shape shape; ///< in its own coordinates, mm
    std::string name;   ///< or empty
    std::function<FaceAttributes(const TopoDS_Shape& face)> attributes_of; ///< may be empty
    std::function<std::vector<std::string>(const TopoDS_Shape& face)>
        remarks_on{}; ///< may be empty
};

/// A placed part.
struct CadInstance {
    std::size_t part = 0; ///< into CadDocument::parts
    std::string name;     ///< or empty
    Affine transform;     ///< from the part's coordinates to the model's, mm
};

/// A face of the file that OpenCASCADE's reader passed over.
struct UnreadFace {
    std::string name;   ///< or empty
    std::string reason; ///< why it is not there, with its entity
};

/// A CAD file as OpenCASCADE read it, in millimetres, before any conversion.
struct CadDocument {
    std::string unit;           ///< of the file, as units.h knows it; empty where it names none
    std::vector<CadPart> parts; ///< each shape once
    std::vector<CadInstance> instances; ///< places of the parts
    std::vector<std::string>
        missing_files;                  ///< which the file names for parts, but which are not there
    std::vector<UnreadFace> lost_faces; ///< in the order they were missed
    std::unordered_map<const TopoDS_TShape*, std::string>
        misread; ///< by face: which of its bounds the reader passed over, or what it changed
    Diagnostics diagnostics; ///< what reading the file has found
};

/// Reads a STEP file. Throws Error naming the file if it cannot be read or holds no shape, or what
/// OpenCASCADE throws.
CadDocument read_step_file(const std::filesystem::path& path);
/// Reads an IGES file. Throws as read_step_file.
CadDocument read_iges_file(const std::filesystem::path& path);
/// Reads a BREP file: one part, placed once, both named after the file. Throws as read_step_file.
CadDocument read_brep_file(const std::filesystem::path& path);

} // namespace keiko::cad
