#include "keiko/import/cad/repair_log.h"

#include <algorithm>

namespace keiko::cad {
namespace {

auto find(auto& repairs, RepairKind kind, const std::string& detail) {
    return std::find_if(repairs.begin(), repairs.end(), [&](const Repair& repair) {
        return repair.kind == kind && repair.detail == detail;
    });
}

} // namespace

void RepairLog::add(RepairKind kind, double size) {
    const auto known = find(repairs_, kind, "");
    if (known == repairs_.end()) {
        repairs_.push_back({0, kind, 1, size, ""});
        return;
    }
    ++known->count;
    known->size = std::max(known->size, size);
}

void RepairLog::add_remark(const std::string& words) {
    const auto known = find(repairs_, RepairKind::by_reader, words);
    if (known == repairs_.end())
        repairs_.push_back({0, RepairKind::by_reader, 1, 0, words});
    else
        ++known->count;
}

std::uint32_t RepairLog::count(RepairKind kind) const {
    std::uint32_t count = 0;
    for (const Repair& repair : repairs_) count += repair.kind == kind ? repair.count : 0;
    return count;
}

} // namespace keiko::cad
