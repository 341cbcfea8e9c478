#include "keiko/render/light_doubts.h"

namespace keiko {

bool holds(const Lights& lights, std::size_t light) {
    return std::binary_search(lights.begin(), lights.end(), light);
}

void without(Lights& lights, const Lights& taken) {
    std::erase_if(lights, [&](std::size_t light) { return holds(taken, light); });
}

std::vector<Doubt> doubts_in(const Lights& lights) {
    std::vector<Doubt> doubts;
    for (const std::size_t light : lights) doubts.push_back({light});
    return doubts;
}

Lights least_doubtful(std::vector<Doubt> doubts, double& left) {
    std::stable_sort(doubts.begin(), doubts.end(),
                     [](const Doubt& a, const Doubt& b) { return a.error < b.error; });
    Lights taken;
    for (const Doubt& doubt : doubts) {
        if (!(doubt.error <= left)) break;
        left -= doubt.error;
        taken.push_back(doubt.light);
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}

} // namespace keiko
