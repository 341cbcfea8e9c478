#include "tests/bench/opencascade_contender.h"

#include "tests/bench/cpu_clock.h"
#include "tests/integration/opencascade_tracer.h"
#include <TopoDS_Shape.hxx>

#include <algorithm>

namespace keiko::bench {
namespace {

class OpenCascadePass final : public Pass {
public:
    OpenCascadePass(test::OpenCascadeTracer& peer, const RaySet& rays, double lift,
                    std::size_t most)
        : peer_(peer), stride_(std::max<std::size_t>(1, rays.rays.size() / most)) {
        for (std::size_t i = 0; i < rays.rays.size(); i += stride_) {
            Ray ray = rays.rays[i];
            if (!rays.leaving_sine.empty()) ray.t_min = lift / std::max(rays.leaving_sine[i], 1e-3);
            rays_.push_back(ray);
        }
        hits_.resize(rays_.size());
    }
    void run() override {
        for (std::size_t i = 0; i < rays_.size(); ++i) hits_[i] = peer_.nearest(rays_[i]);
    }
    Answers answers() const override {
        Answers answers;
        for (const auto& hit : hits_)
            answers.push_back(hit ? std::optional<Answer>({hit->t, peer_.normal(*hit)})
                                  : std::nullopt);
        return answers;
    }
    std::size_t stride() const override { return stride_; }

private:
    test::OpenCascadeTracer& peer_;
    std::size_t stride_;
    std::vector<Ray> rays_;
    std::vector<std::optional<test::PeerHit>> hits_;
};

} // namespace

OpenCascadeContender::OpenCascadeContender(const TopoDS_Shape& shape, double size, std::size_t most)
    : lift_(1e-7 * size), most_(most) {
    facts_.kind = Kind::opencascade;
    facts_.name = "OpenCASCADE";
    facts_.build_seconds =
        process_seconds([&] { peer_ = std::make_unique<test::OpenCascadeTracer>(shape); });
    facts_.elements = peer_->face_count();
}

OpenCascadeContender::~OpenCascadeContender() = default;

std::unique_ptr<Pass> OpenCascadeContender::pass(const RaySet& rays, Mode) const {
    return std::make_unique<OpenCascadePass>(*peer_, rays, lift_, most_);
}

} // namespace keiko::bench
