#include "keiko/report/content/report.h"

#include <algorithm>

namespace keiko {

Verdict verdict_of(const Report& report) {
    const Verdict seams = report.inspection.verdict;
    return report.lines ? std::max(seams, verdict_of(*report.lines)) : seams;
}

} // namespace keiko
