#pragma once

#include <hwy/highway.h>

#include <cstdint>
#include <vector>

namespace keiko::test {

/// Every instruction set that this processor has and Highway was built for, baseline last.
inline std::vector<std::int64_t> instruction_sets() {
    std::vector<std::int64_t> sets;
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1)
        sets.push_back(left & -left);
    return sets;
}

/// Scope in which everything that is made uses the kernels of one instruction set.
class WithInstructionSet {
public:
    explicit WithInstructionSet(std::int64_t set) {
        hwy::SetSupportedTargetsForTest(set);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    ~WithInstructionSet() {
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    WithInstructionSet(const WithInstructionSet&) = delete;
    WithInstructionSet& operator=(const WithInstructionSet&) = delete;
};

} // namespace keiko::test
