#pragma once

#include "tests/bench/embree_rays.h"
#include "tests/bench/triangle_mesh.h"

#include <atomic>
#include <memory>
#include <span>

namespace keiko::bench {

/// An Embree scene of one geometry, built by one thread, that counts its memory.
class EmbreeBody {
public:
    /// Triangles; `mesh` must outlive the body.
    explicit EmbreeBody(const TriangleMesh& mesh);
    /// Boxes whose callback does nothing: what traversal alone costs.
    explicit EmbreeBody(std::span<const Box3> boxes);
    ~EmbreeBody();
    EmbreeBody(const EmbreeBody&) = delete;
    EmbreeBody& operator=(const EmbreeBody&) = delete;

    RTCScene scene() const { return scene_; }
    std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }
    double build_seconds() const { return build_seconds_; }

private:
    EmbreeBody(); ///< an empty scene
    void build(RTCGeometry geometry);

    std::atomic<long> bytes_ = 0; ///< as Embree tells it
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    double build_seconds_ = 0;
};

} // namespace keiko::bench
