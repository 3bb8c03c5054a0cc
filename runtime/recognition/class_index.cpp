#include "runtime/recognition/class_index.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/fnv1a.h"
#include "runtime/base/input_file.h"
#include "runtime/recognition/assignment.h"
#include "runtime/recognition/class_match.h"
#include "schema/class_index_generated.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

constexpr float kDirectionUnit = 32767, kPositionUnit = 8192, kAreaUnit = 65535, kSecondUnit = 4096,
                kThirdUnit = 16384, kScoreUnit = 65535;

// What is wrong with an index, or nothing. The file's name is put before it.
struct Problem {
  std::string what;
  bool found() const { return !what.empty(); }
};

std::string recompile() {
  return "; compile the scene again with this version of aspectc";
}

Problem check_structure(std::span<const std::byte> bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  constexpr std::size_t kSmallest = 16;
  if (bytes.empty()) return {"is empty; an index of a few KiB was expected"};
  if (bytes.size() >= kSmallest && flatbuffers::BufferHasIdentifier(data, "ASPB"))
    return {"holds the indexes of several objects; give one of a single object"};
  if (bytes.size() < kSmallest ||
      !flatbuffers::BufferHasIdentifier(data, fb::ClassIndexIdentifier()))
    return {"is not a class index (no ASPX identifier); give a .aspect file made by aspectc"};
  flatbuffers::Verifier verifier(data, bytes.size(), 16, 1000);
  if (!fb::VerifyClassIndexBuffer(verifier)) {
    return {"is damaged or cut short (its structure does not hold)" + recompile()};
  }
  const fb::ClassIndex* root = fb::GetClassIndex(data);
  if (root->format_version() != kIndexFormatVersion)
    return {"has format version " + std::to_string(root->format_version()) +
            ", this runtime reads " + std::to_string(kIndexFormatVersion) + recompile()};
  const auto* table = reinterpret_cast<const flatbuffers::Table*>(root);
  const std::uint8_t* field = table->GetAddressOf(fb::ClassIndex::VT_CHECKSUM);
  if (field == nullptr ||
      index_checksum(bytes, static_cast<std::size_t>(field - data)) != root->checksum())
    return {"is damaged (its checksum does not fit)" + recompile()};
  return {};
}

bool all_finite(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

bool within(std::uint64_t first, std::uint64_t count, std::size_t size) {
  return first <= size && count <= size - first;
}

// Ranges that follow one another without a gap, as aspectc writes them: shared ones could multiply
// the work of a small file without bound.
class Sequence {
 public:
  explicit Sequence(std::size_t size) : size_(size) {}
  bool takes(std::uint64_t first, std::uint64_t count) {
    if (first != end_ || !within(first, count, size_)) return false;
    end_ += count;
    return true;
  }

 private:
  std::size_t size_;
  std::uint64_t end_ = 0;
};

Vector3 unpack(const fb::Direction& d) {
  const Vector3 v{d.x() / kDirectionUnit, d.y() / kDirectionUnit, d.z() / kDirectionUnit};
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (length <= 0) return {0, 0, 1};
  return {v[0] / length, v[1] / length, v[2] / length};
}

Problem unpack_types(const fb::ClassIndex& root, ClassIndex& index) {
  const auto& numbers = *root.types();
  if (root.type_dimensions() != kTypeDimensions || numbers.size() % kTypeDimensions != 0 ||
      numbers.size() / kTypeDimensions > kMaxTypes)
    return {"has contour types of another kind" + recompile()};
  index.types.resize(numbers.size() / kTypeDimensions);
  for (flatbuffers::uoffset_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers.Get(i))) return {"holds a number that is not finite" + recompile()};
    index.types[i / kTypeDimensions][i % kTypeDimensions] = numbers.Get(i);
  }
  for (const fb::TypeScore* score : *root.type_scores()) {
    if (score->type() >= index.types.size() || !std::isfinite(score->score()))
      return {"names a contour type that it does not hold" + recompile()};
    index.type_scores.push_back({score->type(), score->score()});
  }
  return {};
}

Problem unpack_classes(const fb::ClassIndex& root, ClassIndex& index) {
  index.surfaces.assign(root.surfaces()->begin(), root.surfaces()->end());
  if (root.classes()->size() > kMaxClasses)
    return {"has " + std::to_string(root.classes()->size()) + " classes, more than the " +
            std::to_string(kMaxClasses) + " that there can be" + recompile()};
  Sequence scores(index.type_scores.size()), contours(root.class_contours()->size()),
      key_views(index.key_views.size());
  for (const fb::ClassContour* c : *root.class_contours()) {
    if (!scores.takes(c->first_type(), c->type_count()) ||
        !within(c->first_surface(), c->surface_count(), index.surfaces.size()) ||
        !all_finite({c->centre_x(), c->centre_y(), c->centre_z()}))
      return {"has a contour that points outside of it" + recompile()};
    index.class_contours.push_back(
        {{c->first_type(), c->type_count()},
         {c->first_surface(), c->surface_count()},
         {static_cast<float>(c->share_red()) / 255, static_cast<float>(c->share_green()) / 255,
          static_cast<float>(c->share_blue()) / 255},
         {c->centre_x(), c->centre_y(), c->centre_z()}});
  }
  for (const fb::AspectClass* a : *root.classes()) {
    if (!contours.takes(a->first_contour(), a->contour_count()) ||
        !key_views.takes(a->first_key_view(), a->key_view_count()) ||
        a->contour_count() > kMaxClassContours || !std::isfinite(a->area_fraction()))
      return {"has a class that points outside of it" + recompile()};
    index.classes.push_back({{a->first_contour(), a->contour_count()},
                             {a->first_key_view(), a->key_view_count()},
                             unpack(a->view()),
                             a->area_fraction(),
                             a->view_count()});
  }
  return {};
}

Problem unpack_key_views(const fb::ClassIndex& root, ClassIndex& index) {
  for (const fb::KeyContour* k : *root.key_contours()) {
    KeyContour contour;
    contour.name = k->contour();
    contour.feature.position = {k->x() / kPositionUnit, k->y() / kPositionUnit};
    contour.feature.area = k->area() / kAreaUnit;
    contour.feature.moments = {k->xx() / kSecondUnit, k->xy() / kSecondUnit, k->yy() / kSecondUnit,
                               k->xxx() / kThirdUnit, k->xxy() / kThirdUnit, k->xyy() / kThirdUnit,
                               k->yyy() / kThirdUnit};
    index.key_contours.push_back(contour);
  }
  Sequence contours(index.key_contours.size());
  for (const fb::KeyView* v : *root.key_views()) {
    if (!contours.takes(v->first_contour(), v->contour_count()) || v->contour_count() > kMaxSide)
      return {"has a key view that points outside of it" + recompile()};
    index.key_views.push_back({unpack(v->direction()), {v->first_contour(), v->contour_count()}});
  }
  return {};
}

// Key contours take their colour from the class contour that they are views of.
Problem colour_key_views(ClassIndex& index) {
  for (const AspectClass& aspect : index.classes) {
    for (const KeyView& view : ClassIndex::part(index.key_views, aspect.key_views)) {
      for (std::uint32_t k = 0; k < view.contours.count; ++k) {
        KeyContour& contour = index.key_contours[view.contours.first + k];
        if (contour.name >= aspect.contours.count)
          return {"has a key view with a contour that its class does not have" + recompile()};
        contour.feature.share = index.class_contours[aspect.contours.first + contour.name].share;
      }
    }
  }
  return {};
}

Problem unpack_sphere_map(const fb::ClassIndex& root, ClassIndex& index) {
  const auto& bytes = *root.sphere_map();
  Result<SphereMap> map = SphereMap::decode({bytes.data(), bytes.size()}, index.classes.size());
  if (!map) return {map.error()};
  index.sphere_map = std::move(map).value();
  return {};
}

// The ranges within which segmentation makes sense of its parameters.
Problem unpack_sensor(const fb::ClassIndex& root, VisionParameters& vision) {
  const fb::Segmentation& s = *root.segmentation();
  if (static_cast<std::size_t>(s.sensor()) >= kSensorNames.size())
    return {"was made for a sensor that this runtime does not know" + recompile()};
  vision.sensor = static_cast<SensorKind>(s.sensor());
  if (vision.sensor != SensorKind::range) return {};
  const auto is_within = [](float value, float least, float most) {
    return value >= least && value <= most;  // false where it is not a number
  };
  if (!is_within(s.range_step_length(), 1e-9F, 1e9F) ||
      !is_within(s.range_depth_step(), 1e-5F, 1) || !is_within(s.range_normal_step_deg(), 1, 90) ||
      s.range_steps_min() > s.range_steps_max())
    return {"holds range parameters that cannot be" + recompile()};
  vision.range = {s.range_step_length(), s.range_steps_min(),       s.range_steps_max(),
                  s.range_depth_step(),  s.range_normal_step_deg(), root.field_of_view_deg()};
  return {};
}

bool is_unit(std::span<const float> numbers) {
  float squares = 0;
  for (const float x : numbers) squares += x * x;
  return std::abs(squares - 1) < 1e-3F;  // false where it is not a number
}

// Absent in indexes made before there were any.
Problem unpack_symmetries(const fb::ClassIndex& root, ClassIndex& index) {
  constexpr flatbuffers::uoffset_t kMostSymmetries = 128, kMostAxes = 3;
  const Problem problem{"holds symmetries that cannot be" + recompile()};
  const auto* rotations = root.symmetries();
  const auto* axes = root.symmetry_axes();
  if (rotations != nullptr && rotations->size() > kMostSymmetries) return problem;
  if (axes != nullptr && axes->size() > kMostAxes) return problem;
  for (flatbuffers::uoffset_t k = 0; rotations != nullptr && k < rotations->size(); ++k) {
    const fb::Rotation* r = rotations->Get(k);
    index.symmetries.push_back({r->w(), r->x(), r->y(), r->z()});
    if (!is_unit(index.symmetries.back())) return problem;
  }
  for (flatbuffers::uoffset_t k = 0; axes != nullptr && k < axes->size(); ++k) {
    index.symmetry_axes.push_back({axes->Get(k)->x(), axes->Get(k)->y(), axes->Get(k)->z()});
    if (!is_unit(index.symmetry_axes.back())) return problem;
  }
  const fb::Extent* e = root.extent();
  if (e == nullptr) return {};
  if (!all_finite({e->min_x(), e->min_y(), e->min_z(), e->max_x(), e->max_y(), e->max_z(),
                   e->diameter(), e->centre_x(), e->centre_y(), e->centre_z()}))
    return {"holds a number that is not finite" + recompile()};
  index.extent = {{e->min_x(), e->min_y(), e->min_z()},
                  {e->max_x(), e->max_y(), e->max_z()},
                  e->diameter(),
                  {e->centre_x(), e->centre_y(), e->centre_z()}};
  return {};
}

// Absent where the scene has none.
Problem unpack_model(const fb::ClassIndex& root, ClassIndex& index) {
  const fb::Model* m = root.model();
  if (m == nullptr) return {};
  const Problem problem{"holds a model that cannot be" + recompile()};
  const auto& unit = *m->unit();
  const auto& corner = *m->least();
  const auto& up = *m->up();
  if (!all_finite({unit.x(), unit.y(), unit.z(), corner.x(), corner.y(), corner.z(), up.x(), up.y(),
                   up.z(), m->error()}) ||
      m->vertices()->size() > kMaxModelVertices || m->triangles()->size() > kMaxModelTriangles ||
      m->paints()->size() > kMaxModelColours)
    return problem;
  PaintedModel painted;
  for (const fb::ModelVertex* v : *m->vertices())
    painted.vertices.push_back({corner.x() + unit.x() * v->x(), corner.y() + unit.y() * v->y(),
                                corner.z() + unit.z() * v->z()});
  for (const fb::Paint* p : *m->paints())
    painted.paints.push_back({p->red(), p->green(), p->blue()});
  for (const fb::ModelTriangle* t : *m->triangles()) {
    if (std::max({t->a(), t->b(), t->c()}) >= painted.vertices.size() ||
        t->paint() >= painted.paints.size())
      return problem;
    painted.triangles.push_back({{t->a(), t->b(), t->c()}, static_cast<std::uint8_t>(t->paint())});
  }
  index.model = prepared_model(painted, index.vision.chroma_step, index.vision.intensity_min);
  const Vector3d size{up.x(), up.y(), up.z()};
  if (!(norm(size) > 0) || !(index.model.radius > 0) || !std::isfinite(index.model.radius))
    return problem;
  index.model.up = size;
  index.model.centre = index.extent.centre;
  index.model.error = m->error();
  return {};
}

Problem unpack_surface_names(const fb::ClassIndex& root, ClassIndex& index) {
  if (root.surface_names() == nullptr) return {};
  for (const fb::SurfaceName* name : *root.surface_names())
    index.surface_names.emplace_back(name->surface(), name->name()->str());
  return {};
}

// Without one, the usual one stands.
Problem unpack_calibration(const fb::ClassIndex& root, ClassIndex& index) {
  const fb::Calibration* c = root.calibration();
  if (c == nullptr) return {};
  if (!(c->slope() > 0 && c->slope() <= 1e6F && c->even() >= 0 && c->even() <= 2))
    return {"holds a calibration that cannot be" + recompile()};
  index.calibration = {c->slope(), c->even()};
  return {};
}

// Absent in indexes made before there were any, and where no view was fit for it.
Problem unpack_golden_frame(const fb::ClassIndex& root, ClassIndex& index) {
  const fb::GoldenFrame* g = root.golden_frame();
  if (g == nullptr) return {};
  GoldenFrame golden{g->width_px(),
                     g->height_px(),
                     {g->palette()->begin(), g->palette()->end()},
                     {g->rows()->begin(), g->rows()->end()},
                     g->class_id(),
                     g->regions(),
                     g->matched(),
                     static_cast<float>(g->score()) / kScoreUnit};
  if (!is_sound(golden, index.vision.sensor) || golden.class_id >= index.classes.size())
    return {"holds a golden frame that cannot be" + recompile()};
  index.golden = std::move(golden);
  return {};
}

Problem unpack_settings(const fb::ClassIndex& root, ClassIndex& index) {
  const fb::Segmentation& s = *root.segmentation();
  if (!all_finite({s.thickness_min_px(), root.field_of_view_deg()}) ||
      !(root.field_of_view_deg() > 0 && root.field_of_view_deg() < 180))
    return {"holds a camera that cannot be" + recompile()};
  index.object = root.object()->str();
  index.vision.intensity_min = s.intensity_min();
  index.vision.chroma_step = s.chroma_step();
  index.vision.noise_steps = s.noise_steps();
  index.vision.intensity_step = s.intensity_step();
  index.vision.area_min_px = static_cast<int>(std::min<std::uint32_t>(s.area_min_px(), 1U << 30U));
  index.vision.thickness_min_px = s.thickness_min_px();
  index.vision.smooth = s.smooth();
  if (Problem problem = unpack_sensor(root, index.vision); problem.found()) return problem;
  index.field_of_view_deg = root.field_of_view_deg();
  index.width_px = root.width_px();
  index.height_px = root.height_px();
  index.level = root.provenance()->level();
  index.threshold = root.provenance()->threshold();
  index.cluster_threshold = root.provenance()->cluster_threshold();
  index.scoring = fb::EnumNameScoring(root.scoring());
  return {};
}

}  // namespace

std::uint64_t index_checksum(std::span<const std::byte> bytes, std::size_t checksum_offset) {
  std::uint64_t hash = kFnv1aStart;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const bool own = i >= checksum_offset && i < checksum_offset + sizeof(std::uint64_t);
    hash = fnv1a(hash, own ? std::uint8_t{0} : std::to_integer<std::uint8_t>(bytes[i]));
  }
  return hash;
}

Result<ClassIndex> parse_index(std::span<const std::byte> bytes, const std::string& name) {
  const auto failed = [&](const Problem& problem) { return Error{name + ": " + problem.what}; };
  if (const Problem problem = check_structure(bytes); problem.found()) return failed(problem);
  const fb::ClassIndex& root = *fb::GetClassIndex(bytes.data());
  ClassIndex index;
  index.file_bytes = bytes.size();
  for (const auto& unpack_part : {unpack_settings, unpack_types, unpack_key_views, unpack_classes,
                                  unpack_sphere_map, unpack_symmetries, unpack_surface_names,
                                  unpack_model, unpack_calibration, unpack_golden_frame}) {
    if (const Problem problem = unpack_part(root, index); problem.found()) return failed(problem);
  }
  if (const Problem problem = colour_key_views(index); problem.found()) return failed(problem);
  return index;
}

Result<IndexFileBytes> read_index_bytes(const std::filesystem::path& file) {
  InputFile input(file);
  const std::optional<std::uint64_t> size = input.size();
  if (!size)
    return Error{file.string() + ": cannot be read (" + input.reason() +
                 "); give a .aspect file made by aspectc"};
  if (*size > kMaxIndexBytes)
    return Error{file.string() + ": has " + std::to_string(*size) +
                 " bytes, too many for a class index; give a .aspect file made by aspectc"};
  IndexFileBytes read;
  read.size = static_cast<std::size_t>(*size);
  read.words.resize(read.size / sizeof(std::uint64_t) + 1);
  if (!input.read(std::as_writable_bytes(std::span(read.words)).first(read.size)))
    return Error{file.string() + ": could not be read to its end; check the disk"};
  return read;
}

Result<ClassIndex> load_index(const std::filesystem::path& file) {
  const Result<IndexFileBytes> read = read_index_bytes(file);
  if (!read) return Error{read.error()};
  return parse_index(read.value().bytes(), file.string());
}

}  // namespace aspect
