#include "keiko/report/content/folded_remarks.h"

#include <map>
#include <tuple>

namespace keiko {

std::vector<FoldedRemark> folded_remarks(const Diagnostics& remarks) {
    const auto key = [](const Diagnostic& r) { return std::tie(r.severity, r.entity, r.message); };
    std::map<std::tuple<Severity, std::string, std::string>, std::size_t> times;
    for (const Diagnostic& remark : remarks) ++times[key(remark)];
    std::vector<FoldedRemark> folded;
    for (const Diagnostic& remark : remarks) {
        const auto found = times.find(key(remark));
        if (found == times.end()) continue;
        std::string text = remark.entity + (remark.entity.empty() ? "" : ": ") + remark.message;
        if (found->second > 1) text += " (" + std::to_string(found->second) + " times)";
        folded.push_back({remark.severity, std::move(text)});
        times.erase(found);
    }
    return folded;
}

std::string_view name_of(Severity severity) {
    switch (severity) {
        case Severity::note:
            return "note";
        case Severity::warning:
            return "warning";
        case Severity::error:
            return "error";
    }
    return "";
}

} // namespace keiko
