#pragma once

#include "tests/bench/contender.h"

#include <cstddef>
#include <memory>

class TopoDS_Shape;
namespace keiko::test {
class OpenCascadeTracer;
}

namespace keiko::bench {

/// OpenCASCADE's IntCurvesFace_Intersector, face by face in the order that a box hierarchy gives,
/// each face asked only as far as the nearest hit yet. It traces an even choice of `most` rays: it
/// is hundreds of times slower than the others.
class OpenCascadeContender : public Contender {
public:
    /// `size` of the body in mm.
    OpenCascadeContender(const TopoDS_Shape& shape, double size, std::size_t most);
    ~OpenCascadeContender() override;
    std::vector<Mode> modes() const override { return {Mode::single}; }
    std::unique_ptr<Pass> pass(const RaySet& rays, Mode mode) const override;

private:
    std::unique_ptr<test::OpenCascadeTracer> peer_;
    double lift_;
    std::size_t most_;
};

} // namespace keiko::bench
