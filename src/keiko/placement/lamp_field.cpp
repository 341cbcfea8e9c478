#include "keiko/placement/lamp_field.h"

#include "keiko/light/tubes/tube_hit.h"
#include "keiko/placement/plane_frame.h"

#include <map>

namespace keiko {

LampField::LampField(std::vector<ViewSample> samples)
    : samples_(std::move(samples)), lit_(samples_.size(), false), hidden_(samples_.size(), false) {
    Box3 box;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    for (const ViewSample& s : samples_) {
        total_weight_ += s.weight;
        centroid_ += s.position() * s.weight;
        box.extend(s.position());
        const auto next = static_cast<std::uint32_t>(numbers.size());
        regions_.push_back(numbers.try_emplace({s.instance, s.face}, next).first->second);
    }
    if (total_weight_ > 0) centroid_ /= total_weight_;
    size_ = box.size();
    region_count_ = numbers.size();
}

bool LampField::waits(std::size_t sample) const {
    return !samples_[sample].blocked && !hidden_[sample] && !reached(sample);
}

double LampField::coverage() const {
    double sum = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (reached(i)) sum += samples_[i].weight;
    return total_weight_ > 0 ? sum / total_weight_ : 0;
}

void LampField::place(const CPlane& plane) {
    const PlaneFrame frame = frame_of(plane);
    const CPlaneFrame tubes(plane);
    const Box2 lamps{Vec2(0), Vec2(plane.u.length(), plane.v.length())};
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Vec3& eye = samples_[i].eye;
        const auto tube = nearest_tube(tubes, eye, samples_[i].position() - eye);
        if (tube && tube->t < 1) hidden_[i] = true;
        if (samples_[i].blocked) continue;
        const auto hit = meet(frame, samples_[i].mirror);
        if (hit && hit->cosine >= grazing_cosine && lamps.contains(hit->place)) lit_[i] = true;
    }
}

LampField LampField::thinned(std::size_t count) const {
    const std::size_t step =
        std::max<std::size_t>(1, samples_.size() / std::max<std::size_t>(count, 1));
    std::vector<ViewSample> some;
    for (std::size_t i = step / 2; i < samples_.size(); i += step) some.push_back(samples_[i]);
    return LampField(std::move(some));
}

} // namespace keiko
