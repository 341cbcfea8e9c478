#pragma once

#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepRepr_MappedItem.hxx>
#include <gp_Trsf.hxx>

namespace keiko::cad {

/// The operator that an item is mapped by; none where the item goes from axes to axes.
opencascade::handle<StepGeom_CartesianTransformationOperator3d> mapping_operator(
    const opencascade::handle<StepRepr_MappedItem>& item);

/// The operator as [ISO10303-42] defines it (base_axis, cartesian_transformation_operator_3d): it
/// moves, turns, mirrors and scales. `rigid`, which holds its origin in mm, where its axes or its
/// scale make no map.
gp_Trsf whole(const opencascade::handle<StepGeom_CartesianTransformationOperator3d>& mapping,
              const gp_Trsf& rigid);

} // namespace keiko::cad
