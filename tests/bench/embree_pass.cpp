#include "tests/bench/embree_pass.h"

#include <utility>

namespace keiko::bench {

EmbreePass::EmbreePass(const EmbreeBody& body, const RaySet& rays, EmbreeRays prepared,
                       Reader reader)
    : body_(body),
      coherent_(rays.coherent),
      count_(rays.rays.size()),
      prepared_(std::move(prepared)),
      reader_(std::move(reader)) {}

void EmbreePass::run() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (coherent_) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (RTCRayHit& ray : prepared_.singles) rtcIntersect1(body_.scene(), &context, &ray);
    for (EmbreeRays::Packet& packet : prepared_.packets)
        rtcIntersect16(packet.valid.data(), body_.scene(), &context, &packet.rays);
}

Answers EmbreePass::answers() const {
    Answers answers;
    if (!reader_) return answers;
    for (std::size_t i = 0; i < count_; ++i) {
        const std::optional<EmbreeHit> hit = prepared_.hit(i);
        answers.push_back(hit ? std::optional<Answer>(reader_(*hit)) : std::nullopt);
    }
    return answers;
}

} // namespace keiko::bench
