#include "tools/doctor/face_winding.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace aspect {
namespace {

using Eigen::Vector3d;

struct Piece {
  std::vector<std::uint32_t> faces;
  bool closed = true, has_sides = true;
  double volume = 0;  // once its faces agree with the first
  std::size_t against = 0;
  Eigen::AlignedBox3d box;
};

class Winder {
 public:
  Winder(const FaceSet& set, const std::vector<bool>& kept, const FaceEdges& edges)
      : set_(set), turned_(set.faces.size(), false), is_open_(set.faces.size(), false) {
    for (const auto* pieces : {&edges.open, &edges.borne})
      for (const BorderPiece& piece : *pieces) is_open_[piece.face] = true;
    gather_links(edges);
    std::vector<bool> seen(set.faces.size(), false);
    for (std::uint32_t face = 0; face < set.faces.size(); ++face)
      if (kept[face] && !seen[face]) pieces_.push_back(flood(face, seen));
  }

  FaceWinding judge() {
    FaceWinding winding;
    winding.flipped.assign(set_.faces.size(), false);
    for (const Piece& piece : pieces_) {
      if (!piece.has_sides) {
        ++winding.one_sided;
        append(piece.faces, winding.without_sides);
        continue;
      }
      const bool outwards =
          piece.closed ? piece.volume >= 0 : 2 * piece.against <= piece.faces.size();
      const std::size_t flipped = outwards ? piece.against : piece.faces.size() - piece.against;
      if (flipped == piece.faces.size()) {
        if (is_hollow(piece)) continue;
        ++winding.inside_out;
        winding.inside_out_faces.push_back(piece.faces.front());
        append(piece.faces, winding.inverted);
      } else {
        winding.flipped_count += flipped;
      }
      for (const std::uint32_t face : piece.faces)
        winding.flipped[face] = turned_[face] == outwards;
    }
    return winding;
  }

 private:
  static void append(const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& all) {
    all.insert(all.end(), faces.begin(), faces.end());
  }

  void gather_links(const FaceEdges& edges) {
    first_.assign(set_.faces.size() + 1, 0);
    for (const FaceLink& link : edges.links)
      for (const std::uint32_t face : {link.first, link.second}) ++first_[face + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    links_.resize(2 * edges.links.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const FaceLink& link : edges.links) {
      links_[next[link.first]++] = {link.second, link.agree};
      links_[next[link.second]++] = {link.first, link.agree};
    }
  }

  Piece flood(std::uint32_t start, std::vector<bool>& seen) {
    Piece piece;
    piece.faces.push_back(start);
    seen[start] = true;
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      const std::uint32_t face = piece.faces[k];
      measure(face, piece);
      for (std::size_t l = first_[face]; l < first_[face + 1]; ++l) {
        const auto& [other, agree] = links_[l];
        const bool turned = turned_[face] == agree;
        if (seen[other]) {
          piece.has_sides = piece.has_sides && turned_[other] == turned;
          continue;
        }
        seen[other] = true;
        turned_[other] = turned;
        piece.faces.push_back(other);
      }
    }
    return piece;
  }

  void measure(std::uint32_t face, Piece& piece) const {
    const auto corners = set_.corners_of(face);
    const Vector3d origin = set_.vertices[set_.corners_of(piece.faces.front())[0]];
    const Vector3d a = set_.vertices[corners[0]] - origin;
    double volume = 0;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      volume +=
          a.dot((set_.vertices[corners[k]] - origin).cross(set_.vertices[corners[k + 1]] - origin));
    piece.volume += turned_[face] ? -volume : volume;
    piece.against += turned_[face] ? 1U : 0U;
    piece.closed = piece.closed && !is_open_[face];
    for (const std::uint32_t corner : corners) piece.box.extend(set_.vertices[corner]);
  }

  bool is_hollow(const Piece& piece) const {
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& other) {
      return &other != &piece && other.closed && other.box.contains(piece.box) &&
             !piece.box.contains(other.box);
    });
  }

  const FaceSet& set_;
  std::vector<bool> turned_, is_open_;
  std::vector<std::size_t> first_;
  std::vector<std::pair<std::uint32_t, bool>> links_;
  std::vector<Piece> pieces_;
};

}  // namespace

FaceWinding face_winding(const FaceSet& set, const std::vector<bool>& kept,
                         const FaceEdges& edges) {
  return Winder(set, kept, edges).judge();
}

}  // namespace aspect
