#include "tools/aspectc/commands/inspect_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "compiler/store/store.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/index_bundle.h"
#include "runtime/service/recognition_json.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/inspect_store.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/draw/frame_canvas.h"
#include "tools/draw/index_sheet.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(std::size_t contour) {
  std::array<char, 4> buffer;
  return std::string(contour_name(static_cast<std::uint16_t>(contour), buffer));
}

// Of an index that anyone may have made.
std::string printable(std::string name) {
  for (char& letter : name)
    if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
  return name;
}

Json contour_json(const ClassIndex& index, const ClassContour& contour, std::size_t place) {
  Json json{{"name", name_of(place)}};
  json["share"] = contour.share;
  json["centre"] = contour.centre_object;
  const auto surfaces = ClassIndex::part(index.surfaces, contour.surfaces);
  json["surfaces"] = std::vector<std::uint16_t>(surfaces.begin(), surfaces.end());
  for (const TypeScore& type : ClassIndex::part(index.type_scores, contour.types))
    json["types"].push_back({type.type, type.score});
  return json;
}

Json golden_json(const ClassIndex& index) {
  if (!index.golden) return nullptr;
  const GoldenFrame& golden = *index.golden;
  return {{"width", golden.width_px},
          {"height", golden.height_px},
          {"bytes", golden.palette.size() + golden.rows.size()},
          {"class", golden.class_id},
          {"regions", golden.regions},
          {"matched", golden.matched},
          {"score", golden.score}};
}

void print_golden_frame(const ClassIndex& index) {
  if (!index.golden) return fmt::print("no golden frame\n");
  const GoldenFrame& golden = *index.golden;
  fmt::print("golden frame: {} x {} px in {} bytes, class {} with {} of {} contours at {:.4f}\n",
             golden.width_px, golden.height_px, golden.palette.size() + golden.rows.size(),
             golden.class_id, golden.matched, golden.regions, golden.score);
}

// By directions that are spread evenly, to a hundredth of a percent.
double covered_fraction(const ClassIndex& index) {
  constexpr int kDirections = 20'000;
  constexpr double kGoldenAngle = std::numbers::pi * (3 - 2.23606797749979);
  int covered = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1 - (2 * i + 1.0) / kDirections, radius = std::sqrt(1 - z * z);
    const Vector3d direction{radius * std::cos(kGoldenAngle * i),
                             radius * std::sin(kGoldenAngle * i), z};
    covered += index.sphere_map.class_at(direction) == SphereMap::kNone ? 0 : 1;
  }
  return static_cast<double>(covered) / kDirections;
}

Json index_json(const ClassIndex& index) {
  Json json{{"object", index.object},
            {"bytes", index.file_bytes},
            {"sensor", name_of(index.vision.sensor)},
            {"level", index.level},
            {"threshold", index.threshold},
            {"cluster_threshold", index.cluster_threshold},
            {"scoring", index.scoring},
            {"field_of_view_deg", index.field_of_view_deg},
            {"width", index.width_px},
            {"height", index.height_px},
            {"contour_types", index.types.size()},
            {"key_views", index.key_views.size()},
            {"symmetries", index.symmetries},
            {"symmetry_axes", index.symmetry_axes},
            {"extent",
             {{"min", index.extent.least},
              {"max", index.extent.most},
              {"diameter", index.extent.diameter},
              {"centre", index.extent.centre}}},
            {"golden_frame", golden_json(index)},
            {"covered_fraction", covered_fraction(index)},
            {"classes", Json::array()}};
  for (const auto& [surface, name] : index.surface_names)
    json["surface_names"][std::to_string(surface)] = name;
  for (const AspectClass& aspect : index.classes) {
    Json entry{{"area_fraction", aspect.area_fraction},
               {"views", aspect.view_count},
               {"key_views", aspect.key_views.count},
               {"view", aspect.view},
               {"contours", Json::array()}};
    const auto contours = ClassIndex::part(index.class_contours, aspect.contours);
    for (std::size_t k = 0; k < contours.size(); ++k)
      entry["contours"].push_back(contour_json(index, contours[k], k));
    json["classes"].push_back(std::move(entry));
  }
  return json;
}

void print_symmetries(const ClassIndex& index) {
  for (const Vector3& a : index.symmetry_axes)
    fmt::print("round about the axis {:.4f} {:.4f} {:.4f}\n", a[0], a[1], a[2]);
  for (const std::array<float, 4>& q : index.symmetries) {
    const float sine = std::hypot(q[1], q[2], q[3]);
    fmt::print("the same when turned by {:.2f} degrees about {:.4f} {:.4f} {:.4f}\n",
               2 * std::atan2(sine, q[0]) * 180 / std::numbers::pi_v<float>, q[1] / sine,
               q[2] / sine, q[3] / sine);
  }
  if (index.symmetries.empty() && index.symmetry_axes.empty()) fmt::print("no symmetry\n");
  fmt::print("\n");
}

void print_index(const ClassIndex& index) {
  double area = 0;
  for (const AspectClass& aspect : index.classes) area += static_cast<double>(aspect.area_fraction);
  fmt::print("object {}, seen in {}, {:.1f} KiB, level {}, thresholds {} and {}, scored by {}\n",
             index.object, name_of(index.vision.sensor),
             static_cast<double>(index.file_bytes) / 1024, index.level, index.threshold,
             index.cluster_threshold, index.scoring);
  fmt::print(
      "{} classes over {:.1f} % of the sphere, of which {:.1f} in patches of one aspect; {} "
      "contour "
      "types, {} key views\n",
      index.classes.size(), 100 * covered_fraction(index), 100 * area, index.types.size(),
      index.key_views.size());
  print_symmetries(index);
  print_golden_frame(index);
  fmt::print("class  area %  views  keys  from                    contours (surfaces: types)\n");
  for (std::size_t c = 0; c < index.classes.size(); ++c) {
    const AspectClass& aspect = index.classes[c];
    fmt::print("{:5}  {:6.3f}  {:5}  {:4}  {:+.3f} {:+.3f} {:+.3f} ", c, 100 * aspect.area_fraction,
               aspect.view_count, aspect.key_views.count, aspect.view[0], aspect.view[1],
               aspect.view[2]);
    const auto contours = ClassIndex::part(index.class_contours, aspect.contours);
    for (std::size_t k = 0; k < contours.size(); ++k)
      fmt::print(" {}({}:{})", name_of(k),
                 fmt::join(ClassIndex::part(index.surfaces, contours[k].surfaces), ","),
                 contours[k].types.count);
    fmt::print("\n");
  }
  for (const auto& [surface, name] : index.surface_names)
    fmt::print("surface {}: {}\n", surface, printable(name));
}

int write_golden_frame(const InspectCommand& command) {
  const Result<std::vector<ClassIndex>> indexes = load_index_file(command.index);
  if (!indexes) return fail(indexes.error());
  if (indexes.value().size() != 1)
    return fail(command.index + ": holds several indexes; give one of a single object");
  const ClassIndex& index = indexes.value().front();
  if (!index.golden) return fail(command.index + ": has no golden frame; aspectc warned of it");
  const SensorKind sensor = index.vision.sensor;
  std::vector<std::uint8_t> pixels(golden_picture_bytes(*index.golden, sensor)), png;
  if (!cv::imencode(".png", recorded_picture(decode_golden_frame(*index.golden, sensor, pixels)),
                    png))
    return fail(command.golden + ": the picture could not be encoded");
  const Result<Done> done = write_whole_file(command.golden, png);
  return done ? 0 : fail(done.error());
}

int write_sheet(const InspectCommand& command) {
  if (is_store(command.index))
    return fail(command.index + ": is a store; --sheet draws class indexes (.aspect)");
  const Result<std::vector<ClassIndex>> indexes = load_index_file(command.index);
  if (!indexes) return fail(indexes.error());
  const IndexSheet sheet = index_sheet(indexes.value());
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", sheet.picture, png))
    return fail(command.sheet + ": the picture could not be encoded");
  if (const Result<Done> done = write_whole_file(command.sheet, png); !done)
    return fail(done.error());
  if (sheet.shown == sheet.classes)
    fmt::print("{}: {} class{}\n", command.sheet, sheet.classes, sheet.classes == 1 ? "" : "es");
  else
    fmt::print("{}: {} of {} classes, the largest; --json tells of all\n", command.sheet,
               sheet.shown, sheet.classes);
  return 0;
}

}  // namespace

CLI::App* add_inspect_command(CLI::App& app, InspectCommand& command) {
  CLI::App* inspect = app.add_subcommand("inspect", "Print a class index, or what a store holds.");
  inspect->add_option("index", command.index, "class index (.aspect) or store (.store)")
      ->required()
      ->type_name("FILE.aspect|FILE.store");
  inspect->add_flag("--json", command.json,
                    "everything, as one JSON object; of several indexes a list of them");
  inspect->add_option("--golden", command.golden, "write the golden frame to this picture")
      ->type_name("FILE.png");
  inspect
      ->add_option("--sheet", command.sheet,
                   "write a picture with a tile for each class, the largest first, 400 at most")
      ->type_name("FILE.png");
  inspect->footer(
      "Examples:\n  aspectc inspect part.aspect\n  aspectc inspect part.aspect --sheet part.png\n"
      "  aspectc inspect part.store --json");
  return inspect;
}

int run_inspect(const InspectCommand& command) {
  if (!command.golden.empty())
    if (const int exit_code = write_golden_frame(command); exit_code != 0) return exit_code;
  if (!command.sheet.empty()) return write_sheet(command);
  if (!command.golden.empty()) return 0;
  if (is_store(command.index)) return run_inspect_store(command.index, command.json);
  const Result<std::vector<ClassIndex>> indexes = load_index_file(command.index);
  if (!indexes) return fail(indexes.error());
  Json list = Json::array();
  for (const ClassIndex& index : indexes.value()) {
    if (command.json)
      list.push_back(index_json(index));
    else
      print_index(index);
  }
  if (command.json)
    fmt::print("{}\n", (list.size() == 1 ? list.front() : list)
                           .dump(2, ' ', false, Json::error_handler_t::replace));
  return 0;
}

}  // namespace aspect
