#pragma once

#include "keiko/import/cad/cad_document.h"

#include <TopExp_Explorer.hxx>

#include <string>
#include <unordered_set>

namespace keiko::cad {

/// The faces of a document's parts, to which the shapes of a file's entities are compared.
class ReadFaces {
public:
    /// Keeps a reference to the document, whose parts have been read.
    explicit ReadFaces(CadDocument& document) : document_(document) {
        for (const CadPart& part : document.parts)
            for (TopExp_Explorer face(part.shape, TopAbs_FACE); face.More(); face.Next())
                present_.insert(face.Current().TShape().get());
    }

    /// True if a part has a face of the shape; false for a null shape.
    bool have_one_of(const TopoDS_Shape& shape) const {
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
            if (present_.count(face.Current().TShape().get()) > 0) return true;
        return false;
    }
    /// Notes for all faces of the shape why they are not what the file says; the first reason
    /// stays.
    void misread(const TopoDS_Shape& shape, const std::string& why) {
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
            document_.misread.emplace(face.Current().TShape().get(), why);
    }

private:
    CadDocument& document_;
    std::unordered_set<const TopoDS_TShape*> present_;
};

} // namespace keiko::cad
