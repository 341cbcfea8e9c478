#include "keiko/intersect/hit/reflection_batch.h"

#include "keiko/intersect/hit/reflect_ray.h"

namespace keiko {
namespace {

void put(MirrorBlock::Vectors& to, std::size_t lane, const Vec3& v) {
    to[0][lane] = v.x, to[1][lane] = v.y, to[2][lane] = v.z;
}

Vec3 at(const MirrorBlock::Vectors& from, std::size_t lane) {
    return {from[0][lane], from[1][lane], from[2][lane]};
}

} // namespace

void ReflectionBatch::add(const Ray& incoming, const Hit& hit, Ray& mirrored) {
    if (!incoming.differentials || !hit.second) return reflect_ray(incoming, hit, mirrored);
    asked_[block_.count] = {&incoming, &hit, &mirrored};
    ask(block_.count++);
    if (block_.count == MirrorBlock::capacity) finish();
}

void ReflectionBatch::finish() {
    if (block_.count == 0) return;
    kernel_(block_);
    for (std::size_t lane = 0; lane < block_.count; ++lane) write(lane);
    block_.count = 0;
}

void ReflectionBatch::ask(std::size_t lane) {
    const auto& [incoming, hit, mirrored] = asked_[lane];
    const RayDifferentials& d = *incoming->differentials;
    put(block_.direction, lane, incoming->direction);
    put(block_.incoming.origin_dx, lane, d.origin_dx);
    put(block_.incoming.origin_dy, lane, d.origin_dy);
    put(block_.incoming.direction_dx, lane, d.direction_dx);
    put(block_.incoming.direction_dy, lane, d.direction_dy);
    block_.t[lane] = hit->t;
    put(block_.normal, lane, hit->normal);
    put(block_.du, lane, hit->dpdu), put(block_.dv, lane, hit->dpdv);
    put(block_.duu, lane, hit->second->duu);
    put(block_.duv, lane, hit->second->duv);
    put(block_.dvv, lane, hit->second->dvv);
}

void ReflectionBatch::write(std::size_t lane) const {
    const auto& [incoming, hit, mirrored] = asked_[lane];
    if ((block_.plain >> lane & 1) == 0) return reflect_ray(*incoming, *hit, *mirrored);
    mirrored->origin = hit->position;
    mirrored->direction = at(block_.mirrored_direction, lane);
    mirrored->excluded = hit->root;
    const MirrorBlock::Differentials& from = block_.mirrored;
    RayDifferentials& d = mirrored->differentials.emplace();
    d.origin_dx = at(from.origin_dx, lane), d.origin_dy = at(from.origin_dy, lane);
    d.direction_dx = at(from.direction_dx, lane), d.direction_dy = at(from.direction_dy, lane);
}

} // namespace keiko
