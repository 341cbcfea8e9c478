#include "keiko/inspect/seams/scraps.h"

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace keiko {
namespace {

using FaceKey = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face

std::set<FaceKey> faces_of(const Scrap& scrap) {
    std::set<FaceKey> keys;
    for (const PlacedFace& face : scrap.faces) keys.insert({face.instance, face.face});
    return keys;
}

/// Sets of scraps that continue each other.
DisjointSets lines_of(std::span<const Scrap> scraps, double join) {
    std::vector<SeamEnd> tips;
    std::vector<std::size_t> of; // which scrap each tip is of
    for (std::size_t i = 0; i < scraps.size(); ++i)
        for (const SeamEnd& tip : scraps[i].tips) tips.push_back(tip), of.push_back(i);
    std::vector<Box3> boxes(tips.size());
    for (std::size_t i = 0; i < tips.size(); ++i) boxes[i].extend(tips[i].place);
    const BoxTree tree(boxes);
    const double reach = std::max(join, same_vertex);
    DisjointSets lines(scraps.size());
    for (std::uint32_t i = 0; i < tips.size(); ++i)
        for (const std::uint32_t j : tree.overlapping(boxes[i].padded(reach)))
            if (of[i] < of[j] && goes_on(tips[i], tips[j], join)) lines.join(of[i], of[j]);
    return lines;
}

} // namespace

std::vector<bool> judged_scraps(std::span<const Scrap> scraps, double join) {
    DisjointSets lines = lines_of(scraps, join);
    std::map<FaceKey, double> of_faces;
    std::map<std::size_t, double> of_lines; // by their roots
    for (std::size_t i = 0; i < scraps.size(); ++i) {
        of_lines[lines.root(i)] += scraps[i].length;
        for (const FaceKey& face : faces_of(scraps[i])) of_faces[face] += scraps[i].length;
    }
    std::vector<bool> judged;
    for (std::size_t i = 0; i < scraps.size(); ++i) {
        double longest = of_lines[lines.root(i)];
        for (const FaceKey& face : faces_of(scraps[i])) longest = std::max(longest, of_faces[face]);
        judged.push_back(longest > scraps[i].negligible);
    }
    return judged;
}

} // namespace keiko
