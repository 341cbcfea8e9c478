#pragma once

#include <Standard_Transient.hxx>
#include <StepData_StepModel.hxx>

#include <string>

namespace keiko::cad {

using StepEntity = opencascade::handle<Standard_Transient>;

/// Whether an entity, which may be null, is of a class of OpenCASCADE's.
template <class T>
bool is_a(const StepEntity& entity) {
    return !entity.IsNull() && entity->IsKind(STANDARD_TYPE(T));
}

/// "BOOLEAN_RESULT": the kind of an entity of a file, known to OpenCASCADE or not. One of several
/// kinds has them all, with commas between.
std::string kind_of(const StepEntity& entity, const opencascade::handle<StepData_StepModel>& model);

/// Whether an entity is a shape representation of a kind that OpenCASCADE does not know.
bool is_unknown_shape_representation(const StepEntity& entity);

/// Solids, shells and sets of faces: they are nothing without faces.
bool must_hold_faces(const StepEntity& entity);

/// Whether the faces that an entity holds are all of it. A swept face, a copy or a Boolean result
/// is more than the faces that it refers to.
bool is_made_of_faces(const StepEntity& entity);

/// Triangles, or what is made of them.
bool is_tessellated(const StepEntity& entity);

/// Whether an item of a shape representation has an area or a volume of its own. Of a kind that
/// OpenCASCADE does not know it has, unless its name is that of points, curves, axes or annotation.
bool has_area(const StepEntity& entity);

} // namespace keiko::cad
