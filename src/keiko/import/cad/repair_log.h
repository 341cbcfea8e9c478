#pragma once

#include "keiko/geometry/model/repair.h"

#include <vector>

namespace keiko::cad {

/// The repairs of one face as they are made; those of one kind become one.
class RepairLog {
public:
    /// `size` in mm; 0 where the kind has none.
    void add(RepairKind kind, double size = 0);
    /// What the CAD reader says of the face.
    void add_remark(const std::string& words);

    const std::vector<Repair>& repairs() const { return repairs_; }
    bool empty() const { return repairs_.empty(); }
    /// How many of a kind.
    std::uint32_t count(RepairKind kind) const;

private:
    std::vector<Repair> repairs_; ///< in the order of their first
};

} // namespace keiko::cad
