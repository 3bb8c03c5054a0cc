#include "compiler/index/index_writer.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "compiler/index/golden_choice.h"
#include "runtime/recognition/class_index.h"
#include "schema/class_index_generated.h"
#include "tests/compiler/index/index_contents.h"

namespace aspect {
namespace {

Result<ClassIndex> parsed(const WrittenIndex& written) {
  return parse_index(std::as_bytes(std::span(written.bytes)), "written");
}

// Half a unit of what a field is kept in, and what floats round away.
void check_near(double read, double written, double unit) {
  CHECK(std::abs(read - written) <= 0.5 / unit + 1e-6);
}
// In 16 bits; the moments of the thinnest slivers are cut off there.
void check_near(float read, float written, double unit) {
  const bool has_sign = unit < 65535;
  const double least = has_sign ? -32768 / unit : 0, most = has_sign ? 32767 / unit : 1;
  check_near(static_cast<double>(read), std::clamp(static_cast<double>(written), least, most),
             unit);
}

void check_direction(const Vector3& read, const Eigen::Vector3d& written) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    check_near(static_cast<double>(read[axis]), written[static_cast<Eigen::Index>(axis)], 10000);
}

void check_feature(const ContourFeature& read, const ContourFeature& written) {
  check_near(read.position.x, written.position.x, 8192);
  check_near(read.position.y, written.position.y, 8192);
  check_near(read.area, written.area, 65535);
  check_near(read.moments.xx, written.moments.xx, 4096);
  check_near(read.moments.xy, written.moments.xy, 4096);
  check_near(read.moments.yy, written.moments.yy, 4096);
  check_near(read.moments.xxx, written.moments.xxx, 16384);
  check_near(read.moments.xxy, written.moments.xxy, 16384);
  check_near(read.moments.xyy, written.moments.xyy, 16384);
  check_near(read.moments.yyy, written.moments.yyy, 16384);
}

void check_contour(const ClassIndex& index, const ClassContour& read,
                   const ContourDescription& written) {
  const auto scores = ClassIndex::part(index.type_scores, read.types);
  REQUIRE(scores.size() == written.score_of_type.size());
  std::size_t k = 0;
  for (const auto& [type, score] : written.score_of_type) {
    CHECK(scores[k].type == type);
    CHECK(scores[k++].score == static_cast<float>(score));
  }
  const auto surfaces = ClassIndex::part(index.surfaces, read.surfaces);
  CHECK(std::vector(surfaces.begin(), surfaces.end()) == written.surfaces);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    check_near(static_cast<double>(read.share[channel]), written.share[channel], 255);
    CHECK(read.centre_object[channel] ==
          static_cast<float>(written.centre_object[static_cast<Eigen::Index>(channel)]));
  }
}

// A key view is one of its cluster's, contour by contour.
void check_key_view(const DescribedModel& described, std::size_t class_id, const ClassIndex& index,
                    const KeyView& key) {
  const Subdivision& s = described.model.subdivision;
  const Cluster& cluster = described.clusters[class_id];
  const Eigen::Vector3f direction(key.direction[0], key.direction[1], key.direction[2]);
  const ClusterView* view = &cluster.views.front();
  for (const ClusterView& other : cluster.views)
    if ((s.direction(other.vertex) - direction.cast<double>()).norm() <
        (s.direction(view->vertex) - direction.cast<double>()).norm())
      view = &other;
  check_direction(key.direction, s.direction(view->vertex));
  const auto contours = ClassIndex::part(index.key_contours, key.contours);
  REQUIRE(contours.size() == cluster.contour_count);
  const ObservedView& seen = s.views[place_of(view->vertex)];
  for (std::size_t i = 0; i < contours.size(); ++i) {
    CHECK(contours[i].name == view->names[i]);
    check_feature(contours[i].feature, seen.contours[i].feature);
    // Colours are the class's.
    const AspectClass& aspect = index.classes[class_id];
    CHECK(contours[i].feature.share ==
          index.class_contours[aspect.contours.first + view->names[i]].share);
  }
}

void check_class(const DescribedModel& described, std::size_t class_id, const ClassIndex& index) {
  const AspectClass& read = index.classes[class_id];
  const Cluster& cluster = described.clusters[class_id];
  const ClassDescription& written = described.classes[class_id];
  CHECK(read.area_fraction == static_cast<float>(cluster.area_fraction));
  CHECK(read.view_count == cluster.views.size());
  check_direction(
      read.view, described.model.subdivision.direction(cluster.views[written.typical_view].vertex));
  const auto contours = ClassIndex::part(index.class_contours, read.contours);
  REQUIRE(contours.size() == written.contours.size());
  for (std::size_t k = 0; k < contours.size(); ++k)
    check_contour(index, contours[k], written.contours[k]);
  REQUIRE(read.key_views.count > 0);
  for (const KeyView& key : ClassIndex::part(index.key_views, read.key_views))
    check_key_view(described, class_id, index, key);
}

// Settings that are no defaults, each of its own value.
void change_settings(CompileOptions& options) {
  options.threshold = 12345.5;
  options.cluster_threshold = 54321.25;
  options.vision.intensity_min = 50;
  options.vision.chroma_step = 9;
  options.vision.noise_steps = 2;
  options.vision.intensity_step = 700;
  options.vision.area_min_px = 70000;
  options.vision.thickness_min_px = 4.5F;
  options.vision.smooth = false;
}

}  // namespace

TEST_CASE("what was written is read again, class by class") {
  for (const Scoring scoring : {Scoring::none, Scoring::views, Scoring::area}) {
    const DescribedModel described = described_model("l_shape", 3, scoring);
    const WrittenIndex written = write_index(described.contents());
    const Result<ClassIndex> index = parsed(written);
    REQUIRE(index.ok());
    CHECK(index.value().classes.size() == described.clusters.size());
    CHECK(written.statistics.classes == described.clusters.size());
    CHECK(written.statistics.key_views == index.value().key_views.size());
    CHECK(index.value().types == described.types);
    for (std::size_t c = 0; c < index.value().classes.size(); ++c)
      check_class(described, c, index.value());
  }
}

TEST_CASE("the settings of the compilation are read again") {
  DescribedModel described = described_model("cube", 3, Scoring::area);
  change_settings(described.options);
  const WrittenIndex written = write_index(described.contents());
  const ClassIndex index = parsed(written).value();
  const VisionParameters &read = index.vision, &v = described.options.vision;
  CHECK(read.intensity_min == v.intensity_min);
  CHECK(read.chroma_step == v.chroma_step);
  CHECK(read.noise_steps == v.noise_steps);
  CHECK(read.intensity_step == v.intensity_step);
  CHECK(read.area_min_px == v.area_min_px);
  CHECK(read.thickness_min_px == v.thickness_min_px);
  CHECK(read.smooth == v.smooth);
  CHECK(index.object == "cube");
  CHECK(index.field_of_view_deg == 50);
  CHECK((index.width_px == 512 && index.height_px == 512));
  CHECK(index.level == 3);
  CHECK(index.threshold == 12345.5);
  CHECK(index.cluster_threshold == 54321.25);
  CHECK(index.scoring == "area");
  CHECK(index.file_bytes == written.bytes.size());
  const auto* provenance = schema::GetClassIndex(written.bytes.data())->provenance();
  CHECK(provenance->scene_hash() == DescribedModel::kSceneHash);
  CHECK(provenance->min_level() == 3);
}

TEST_CASE("the sensor and its parameters are read again") {
  DescribedModel described = described_model("cube", 3);
  for (const SensorKind sensor : {SensorKind::grey, SensorKind::range, SensorKind::surface}) {
    VisionParameters& v = described.options.vision;
    v.sensor = sensor;
    v.range = {0.002F, 300, 4000, 0.03F, 17.5F, 0};
    const WrittenIndex written = write_index(described.contents());
    const ClassIndex index = parsed(written).value();
    CHECK(index.vision.sensor == sensor);
    if (sensor != SensorKind::range) continue;
    CHECK(index.vision.range.step_length == 0.002F);
    CHECK(index.vision.range.steps_min == 300);
    CHECK(index.vision.range.steps_max == 4000);
    CHECK(index.vision.range.depth_step == 0.03F);
    CHECK(index.vision.range.normal_step_deg == 17.5F);
    CHECK(index.vision.range.field_of_view_deg == index.field_of_view_deg);
  }
}

TEST_CASE("a sensor's parameters that cannot be are refused in one line") {
  DescribedModel described = described_model("cube", 3);
  described.options.vision.sensor = SensorKind::range;
  const RangeParameters good;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const RangeParameters& bad :
       {RangeParameters{nan, 1, 9, 0.01F, 12, 50}, RangeParameters{0, 1, 9, 0.01F, 12, 50},
        RangeParameters{1e-4F, 10, 9, 0.01F, 12, 50}, RangeParameters{1e-4F, 1, 9, nan, 12, 50},
        RangeParameters{1e-4F, 1, 9, 0, 12, 50}, RangeParameters{1e-4F, 1, 9, 0.01F, nan, 50},
        RangeParameters{1e-4F, 1, 9, 0.01F, 200, 50}}) {
    described.options.vision.range = bad;
    const Result<ClassIndex> index = parsed(write_index(described.contents()));
    REQUIRE_FALSE(index.ok());
    CHECK(index.error().find("range parameters that cannot be") != std::string::npos);
  }
  described.options.vision.range = good;
  CHECK(parsed(write_index(described.contents())).ok());
}

TEST_CASE("the index maps every leaf of the viewing sphere to its class") {
  const DescribedModel described = described_model("cube", 3);
  const ClassIndex index = parsed(write_index(described.contents())).value();
  for (std::size_t c = 0; c < described.clusters.size(); ++c) {
    for (const PatchId patch : described.clusters[c].patches) {
      Eigen::Vector3d middle(0, 0, 0);
      for (const VertexId corner : described.model.subdivision.sphere.patch(patch).corners)
        middle += described.model.subdivision.sphere.position(corner);
      CHECK(index.sphere_map.class_at({middle.x(), middle.y(), middle.z()}) ==
            static_cast<std::int32_t>(c));
    }
  }
}

TEST_CASE("the same contents give the same bytes") {
  const DescribedModel described = described_model("l_shape", 3);
  CHECK(write_index(described.contents()).bytes == write_index(described.contents()).bytes);
}

TEST_CASE("an index keeps within its budget, by fewer key views first, then fewer classes") {
  DescribedModel described = described_model("l_shape", 3);
  WrittenIndex larger = write_index(described.contents());
  CHECK(larger.statistics.classes == described.clusters.size());
  for (const std::size_t kib : {48U, 32U, 16U, 8U, 4U}) {
    described.options.max_index_bytes = kib * 1024;
    const WrittenIndex written = write_index(described.contents());
    INFO(kib << " KiB: " << written.statistics.classes << " classes, "
             << written.statistics.key_views << " key views");
    CHECK(written.bytes.size() <= kib * 1024);
    // A budget is there to be used.
    CHECK(written.bytes.size() >= kib * 1024 * 6 / 10);
    CHECK(written.statistics.classes <= larger.statistics.classes);
    CHECK(written.statistics.key_views <= larger.statistics.key_views);
    CHECK(written.statistics.classes > 0);
    CHECK(written.statistics.key_views >= written.statistics.classes);
    if (written.statistics.classes < described.clusters.size())
      CHECK(written.statistics.key_view_spacing_deg >= 60);
    const Result<ClassIndex> index = parsed(written);
    REQUIRE(index.ok());
    REQUIRE(index.value().classes.size() == written.statistics.classes);
    double area = 0;
    for (std::size_t c = 0; c < written.statistics.classes; ++c) {
      check_class(described, c, index.value());
      area += described.clusters[c].area_fraction;
    }
    CHECK(written.statistics.area_fraction == Approx(area));
    larger = written;
  }
}

TEST_CASE("a golden frame keeps within the budget and within the bytes that it was said to take") {
  DescribedModel described = described_model("l_shape", 3);
  const Renderer renderer = Renderer::create(described.model.scene).value();
  for (const std::size_t kib : {1024U, 32U, 12U, 5U}) {
    described.options.max_index_bytes = kib * 1024;
    const Workshop workshop{renderer, described.model.scene.studio, described.options, nullptr, {},
                            nullptr};
    const auto candidates = golden_candidates(workshop, described.model.subdivision,
                                              described.clusters, described.classes);
    IndexContents contents = described.contents();
    contents.golden_candidates = candidates;
    const WrittenIndex written = write_index(contents);
    INFO(kib << " KiB, " << candidates.size() << " candidates");
    CHECK(written.bytes.size() <= kib * 1024);
    const ClassIndex index = parsed(written).value();
    REQUIRE(index.golden);
    CHECK(written.statistics.golden_frame_bytes > 0);
    CHECK(written.statistics.golden_frame_bytes <= golden_bytes(*index.golden));
    CHECK(golden_bytes(*index.golden) <= kib * 1024 / 8);
    CHECK(index.golden->class_id < written.statistics.classes);
  }
  CHECK_FALSE(parsed(write_index(described.contents())).value().golden);
}

TEST_CASE("more surfaces than 16 bits can count are left out, and the index can be read") {
  DescribedModel described = described_model("l_shape", 3);
  described.options.max_index_bytes = 16U << 20U;
  std::vector<std::uint16_t> many(1000);
  for (std::size_t k = 0; k < many.size(); ++k) many[k] = static_cast<std::uint16_t>(k + 1);
  std::size_t contours = 0;
  const std::size_t copies = 300 / described.clusters.size() + 1;
  std::vector<Cluster> clusters;
  std::vector<ClassDescription> classes;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    for (std::size_t c = 0; c < described.clusters.size(); ++c) {
      clusters.push_back(described.clusters[c]);
      classes.push_back(described.classes[c]);
      for (ContourDescription& contour : classes.back().contours) contour.surfaces = many;
      contours += classes.back().contours.size();
    }
  }
  REQUIRE(contours * 255 > 65536);
  IndexContents contents = described.contents();
  contents.clusters = clusters;
  contents.classes = classes;
  const Result<ClassIndex> index = parsed(write_index(contents));
  INFO((index.ok() ? "" : index.error()));
  REQUIRE(index.ok());
  CHECK(index.value().surfaces.size() <= 65535);
  for (const ClassContour& contour : index.value().class_contours) {
    const auto surfaces = ClassIndex::part(index.value().surfaces, contour.surfaces);
    if (!surfaces.empty()) CHECK((surfaces.size() == 255 && surfaces.front() == 1));
  }
}

}  // namespace aspect
