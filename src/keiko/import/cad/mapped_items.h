#pragma once

#include "keiko/base/error.h"
#include "keiko/math/affine.h"

#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>

#include <optional>
#include <string>
#include <vector>

namespace keiko::cad {

/// Mapped items of a STEP file whose operators mirror or scale: OpenCASCADE only moves and turns
/// what they map. Items may map representations that hold items, and stand in products of an
/// assembly.
class MappedItems {
public:
    /// None.
    MappedItems() = default;
    /// Mapped items of a file that has been transferred.
    explicit MappedItems(const opencascade::handle<XSControl_WorkSession>& session);

    /// Map that each shape of an assembly needs before it is placed: mostly the identity. A root of
    /// the file is an assembly of one.
    std::vector<Affine> corrections(const std::vector<TopoDS_Shape>& components);

    /// Whether a product of the file that is in no other shows this shape.
    bool is_product(const TopoDS_Shape& shape) const;

    /// A warning for each assembly that corrections() never met: what it places stays as
    /// OpenCASCADE put it.
    void remark_unmet(Diagnostics& diagnostics) const;

private:
    friend class MappedItemReader;

    struct Component {
        TopoDS_Shape shape; ///< where OpenCASCADE put it
        std::optional<Affine> correction{};
    };
    struct Assembly {
        std::vector<Component> components;
        std::string label; ///< of an entity that mirrors or scales
        bool met = false;

        /// The corrections of `shapes` if they are what the assembly is made of.
        std::optional<std::vector<Affine>> match(const std::vector<TopoDS_Shape>& shapes) const;
    };

    std::vector<Assembly> assemblies_;
    std::vector<TopoDS_Shape> products_;
};

} // namespace keiko::cad
