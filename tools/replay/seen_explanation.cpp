#include "tools/replay/seen_explanation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "runtime/base/planned_memory.h"
#include "runtime/recognition/model_drawing.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {
namespace {

// A piece is missing where less of it than this is seen. What is smaller than this share of the
// blob is blur.
constexpr float kSeen = 0.75F, kLeastShare = 0.01F;

std::span<const ClassContour> contours_of(const ClassIndex& index, std::size_t class_id) {
  return ClassIndex::part(index.class_contours, index.classes[class_id].contours);
}

struct DrawnPiece {
  ColourClass colour = kBackgroundClass;
  std::vector<int> cells;
  int same = 0, blurred = 0;
  const ClassContour* contour = nullptr;

  // Cells that blur may have taken do not count, unless it may have taken most of the piece.
  float covered() const {
    const int all = static_cast<int>(cells.size());
    return static_cast<float>(same) /
           static_cast<float>(2 * blurred > all ? all : std::max(1, all - blurred));
  }
};

// The drawn model laid beside the picture, cell by cell.
class Comparison {
 public:
  Comparison(const Hypothesis& hypothesis, const RigidPose& pose, const SeenPlace& place,
             const SeenFrame& frame)
      : frame_(frame),
        index_(frame.indexes[hypothesis.index]),
        camera_(frame.cameras[hypothesis.index]),
        place_(place) {
    const Blob& blob = frame.graph.blobs[place.blob];
    const Box& box = place.part ? *place.part : blob.box;
    area_px_ =
        place.part ? static_cast<float>(box.width) * static_cast<float>(box.height) : blob.area_px;
    memory_.plan([&](Arena& arena) { drawing_.prepare(arena, index_.model.vertices.size()); });
    if (!drawing_.draw(index_.model, pose, camera_, box)) return;
    is_drawn_ = true;
    seen_.look(*frame.regions, *frame.colours,
               place.part ? SeenColours::kAllBlobs : static_cast<int>(place.blob), index_.model,
               hypothesis.start.light);
    find_pieces();
    name_pieces(hypothesis.class_id, pose);
    compare();
  }

  // False: a part of the object would be behind the camera.
  bool is_drawn() const { return is_drawn_; }

  std::vector<MissingPart> missing(std::size_t class_id) const {
    std::vector<MissingPart> parts;
    for (const DrawnPiece& piece : pieces_) {
      const float covered = piece.covered();
      const float area = area_of(static_cast<int>(piece.cells.size()));
      if (covered >= kSeen || area < least_area()) continue;
      MissingPart part;
      part.colour = index_.model.shares[piece.colour - std::size_t{1}];
      part.area_px = area;
      part.covered = covered;
      if (piece.contour != nullptr) {
        part.name =
            static_cast<std::uint16_t>(piece.contour - contours_of(index_, class_id).data());
        part.surfaces = ClassIndex::part(index_.surfaces, piece.contour->surfaces);
      }
      parts.push_back(part);
    }
    std::stable_sort(parts.begin(), parts.end(), [](const MissingPart& a, const MissingPart& b) {
      return *a.area_px > *b.area_px;
    });
    return parts;
  }

  std::vector<Contradiction> contradicting() const {
    std::vector<Contradiction> found;
    for (const auto& [place, cells] : wrong_) {
      const auto& [label, drawn] = place;
      if (area_of(cells) < least_area()) continue;
      if (place_.part && drawn == kBackgroundClass) continue;
      for (const Contour& contour : frame_.graph.contours) {
        if (contour.region != label || !contour.external) continue;
        Contradiction contradiction;
        contradiction.contour = static_cast<std::uint16_t>(&contour - frame_.graph.contours.data());
        contradiction.colour = share_of(contour.mean_rgb);
        if (drawn != kBackgroundClass)
          contradiction.drawn = index_.model.shares[drawn - std::size_t{1}];
        contradiction.area_px = area_of(cells);
        found.push_back(contradiction);
        break;
      }
    }
    return found;
  }

 private:
  float area_of(int cells) const {
    return static_cast<float>(cells) * drawing_.cell_px() * drawing_.cell_px();
  }
  float least_area() const { return kLeastShare * area_px_; }

  ColourClass drawn_at(int column, int row) const {
    const bool inside =
        column >= 0 && row >= 0 && column < drawing_.width() && row < drawing_.height();
    return inside ? drawing_.cell(column, row).colour : kBackgroundClass;
  }

  int& piece_at(int column, int row) {
    return piece_of_[static_cast<std::size_t>(row) * static_cast<std::size_t>(drawing_.width()) +
                     static_cast<std::size_t>(column)];
  }

  void find_pieces() {
    const int width = drawing_.width(), height = drawing_.height();
    piece_of_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
    for (int first = 0; first < width * height; ++first) {
      const ColourClass colour = drawn_at(first % width, first / width);
      if (colour == kBackgroundClass || piece_at(first % width, first / width) >= 0) continue;
      DrawnPiece piece;
      piece.colour = colour;
      const auto take = [&](int column, int row) {
        if (drawn_at(column, row) != colour) return;
        int& owner = piece_at(column, row);
        if (owner >= 0) return;
        owner = static_cast<int>(pieces_.size());
        piece.cells.push_back(row * width + column);
      };
      take(first % width, first / width);
      for (std::size_t k = 0; k < piece.cells.size(); ++k) {
        const int column = piece.cells[k] % width, row = piece.cells[k] / width;
        take(column - 1, row);
        take(column + 1, row);
        take(column, row - 1);
        take(column, row + 1);
      }
      pieces_.push_back(std::move(piece));
    }
  }

  // By the class's contours whose centres, as the pose has them, lie on a piece of their colour.
  void name_pieces(std::size_t class_id, const RigidPose& pose) {
    for (const ClassContour& contour : contours_of(index_, class_id)) {
      const Vector3d p = pose({static_cast<double>(contour.centre_object[0]),
                               static_cast<double>(contour.centre_object[1]),
                               static_cast<double>(contour.centre_object[2])});
      if (!(p[2] > 0)) continue;
      const auto cell = [&](double straight_px, float first_px) {
        const double cells =
            (straight_px - static_cast<double>(first_px)) / static_cast<double>(drawing_.cell_px());
        return static_cast<int>(std::lround(std::clamp(cells, -1.0, 1e6)));
      };
      const int column = cell(camera_.cx_px + camera_.fx_px * p[0] / p[2], drawing_.x_px(0)),
                row = cell(camera_.cy_px + camera_.fy_px * p[1] / p[2], drawing_.y_px(0));
      const ColourClass colour = drawn_at(column, row);
      if (colour == kBackgroundClass || colour != nearest_colour(contour.share)) continue;
      DrawnPiece& piece = pieces_[static_cast<std::size_t>(piece_at(column, row))];
      if (piece.contour == nullptr) piece.contour = &contour;
    }
  }

  ColourClass nearest_colour(const ColourShare& share) const {
    ColourClass nearest = kBackgroundClass;
    float least = 4;
    for (std::size_t k = 0; k < index_.model.shares.size(); ++k) {
      float distance = 0;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const float difference = share[channel] - index_.model.shares[k][channel];
        distance += difference * difference;
      }
      if (distance >= least) continue;
      least = distance;
      nearest = static_cast<ColourClass>(k + 1);
    }
    return nearest;
  }

  std::uint16_t label_at(float x_px, float y_px) const {
    const RegionMap& regions = *frame_.regions;
    const int x = static_cast<int>(std::floor(x_px + 0.5F)),
              y = static_cast<int>(std::floor(y_px + 0.5F));
    const Box& box = regions.active;
    if (x < box.x || y < box.y || x >= box.x + box.width || y >= box.y + box.height) return 0;
    return regions
        .labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(regions.stride_px) +
                static_cast<std::size_t>(x)];
  }

  // The rules are those of agreement(), so that what is told here is what the score lacks.
  void compare() {
    const int rim = drawing_.cell_px() < 1.5F ? 2 : 1;
    for (int row = 0; row < drawing_.height(); ++row)
      for (int column = 0; column < drawing_.width(); ++column) {
        const Point2d p = camera_.bent(
            {static_cast<double>(drawing_.x_px(column)), static_cast<double>(drawing_.y_px(row))});
        const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
        const ColourClass drawn = drawn_at(column, row), region = seen_.at(x, y),
                          pixel = seen_.at_pixel(x, y);
        DrawnPiece* piece = nullptr;
        if (drawn != kBackgroundClass)
          piece = &pieces_[static_cast<std::size_t>(piece_at(column, row))];
        if (region == drawn || (pixel == drawn && piece != nullptr)) {
          if (piece != nullptr) ++piece->same;
          continue;
        }
        const auto shows_beside = [&](int right, int down) {
          const ColourClass beside = drawn_at(column + right, row + down);
          return beside != drawn && (beside == region || beside == pixel);
        };
        if (shows_beside(-rim, 0) || shows_beside(rim, 0) || shows_beside(0, -rim) ||
            shows_beside(0, rim)) {
          if (piece != nullptr) ++piece->blurred;
        } else if (region != kBackgroundClass) {
          ++wrong_[{label_at(x, y), drawn}];
        }
      }
  }

  const SeenFrame& frame_;
  const ClassIndex& index_;
  const CameraModel& camera_;
  SeenPlace place_;
  float area_px_ = 0;  // of what is seen of it, or of its box
  bool is_drawn_ = false;
  PlannedMemory memory_;
  ModelDrawing drawing_;
  SeenColours seen_;
  std::vector<DrawnPiece> pieces_;
  std::vector<int> piece_of_;                                   // by cell, -1: none
  std::map<std::pair<std::uint16_t, ColourClass>, int> wrong_;  // by label and drawn colour
};

void compare_contours(const Hypothesis& hypothesis, const SeenPlace& place, const SeenFrame& frame,
                      SeenExplanation& explanation) {
  const ClassIndex& index = frame.indexes[hypothesis.index];
  const auto contours = contours_of(index, hypothesis.class_id);
  const auto is_matched = [&](auto&& of_match, std::size_t number) {
    return std::any_of(hypothesis.contours.begin(), hypothesis.contours.end(),
                       [&](const ContourMatch& match) { return of_match(match) == number; });
  };
  for (std::size_t name = 0; name < contours.size(); ++name) {
    if (is_matched([](const ContourMatch& match) { return match.name; }, name)) continue;
    MissingPart part;
    part.name = static_cast<std::uint16_t>(name);
    part.surfaces = ClassIndex::part(index.surfaces, contours[name].surfaces);
    part.colour = contours[name].share;
    explanation.missing.push_back(part);
  }
  if (place.part) return;
  const Blob& seen = frame.graph.blobs[place.blob];
  for (int k = 0; k < seen.contour_count; ++k) {
    const auto number = static_cast<std::size_t>(seen.first_contour) + static_cast<std::size_t>(k);
    const Contour& contour = frame.graph.contours[number];
    if (!contour.external ||
        is_matched([](const ContourMatch& match) { return match.contour; }, number))
      continue;
    Contradiction contradiction;
    contradiction.contour = static_cast<std::uint16_t>(number);
    contradiction.colour = share_of(contour.mean_rgb);
    contradiction.area_px = contour.area_px;
    explanation.contradicting.push_back(contradiction);
  }
}

}  // namespace

SeenPlace place_of(const SeenObject& object, const ViewGraph& graph) {
  SeenPlace place{object.blob, {}};
  if (graph.blobs[object.blob].box != object.box) place.part = object.box;
  return place;
}

SeenExplanation explain_seen(const Hypothesis& hypothesis, const VerifiedPose* pose,
                             const SeenPlace& place, const SeenFrame& frame) {
  const ClassIndex& index = frame.indexes[hypothesis.index];
  const auto contours = contours_of(index, hypothesis.class_id);
  SeenExplanation explanation;
  for (const ContourMatch& match : hypothesis.contours)
    explanation.contours.push_back({match.contour, match.name,
                                    ClassIndex::part(index.surfaces, contours[match.name].surfaces),
                                    share_of(frame.graph.contours[match.contour].mean_rgb)});
  std::optional<Comparison> comparison;
  if (pose != nullptr) comparison.emplace(hypothesis, pose->refined.pose, place, frame);
  if (comparison && comparison->is_drawn()) {
    explanation.missing = comparison->missing(hypothesis.class_id);
    explanation.contradicting = comparison->contradicting();
  } else {
    compare_contours(hypothesis, place, frame, explanation);
  }
  std::stable_sort(
      explanation.contradicting.begin(), explanation.contradicting.end(),
      [](const Contradiction& a, const Contradiction& b) { return a.area_px > b.area_px; });
  return explanation;
}

}  // namespace aspect
