#include "tests/bench/embree_body.h"

#include "tests/bench/cpu_clock.h"

#include <stdexcept>
#include <string>

namespace keiko::bench {
namespace {

void on_bounds(const RTCBoundsFunctionArguments* arguments) {
    const Box3& box = static_cast<const Box3*>(arguments->geometryUserPtr)[arguments->primID];
    *arguments->bounds_o = {
        round_down(box.lower.x), round_down(box.lower.y), round_down(box.lower.z), 0,
        round_up(box.upper.x),   round_up(box.upper.y),   round_up(box.upper.z),   0};
}

void on_intersect(const RTCIntersectFunctionNArguments*) {}

bool on_memory(void* counter, ssize_t bytes, bool) {
    static_cast<std::atomic<long>*>(counter)->fetch_add(bytes);
    return true;
}

void share(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const void* data,
           std::size_t count) {
    rtcSetSharedGeometryBuffer(geometry, type, 0, format, data, 0, 12, count);
}

} // namespace

EmbreeBody::EmbreeBody() : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetDeviceMemoryMonitorFunction(device_, on_memory, &bytes_);
}

EmbreeBody::EmbreeBody(const TriangleMesh& mesh) : EmbreeBody() {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    share(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions.data(),
          mesh.positions.size() - 1); // the last one is the padding that Embree reads beyond
    share(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles.data(),
          mesh.triangles.size());
    build(geometry);
}

EmbreeBody::EmbreeBody(std::span<const Box3> boxes) : EmbreeBody() {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST); // as Keiko must
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, const_cast<Box3*>(boxes.data()));
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* a) { on_bounds(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, on_intersect);
    build(geometry);
}

void EmbreeBody::build(RTCGeometry geometry) {
    build_seconds_ = process_seconds([&] {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    });
    if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE)
        throw std::runtime_error("Embree error " + std::to_string(error));
}

EmbreeBody::~EmbreeBody() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

} // namespace keiko::bench
