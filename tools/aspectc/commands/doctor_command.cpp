#include "tools/aspectc/commands/doctor_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "compiler/scene/bob_writer.h"
#include "compiler/scene/scene_reader.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/aspectc/project/scene_settings.h"
#include "tools/command_line/command_line.h"
#include "tools/doctor/finding_picture.h"
#include "tools/doctor/merged_colours.h"
#include "tools/doctor/report.h"

namespace aspect {
namespace {

constexpr const char* kKeys =
    R"(Exit code: 0 no error and no warning (notes are allowed; with --fix: none is left), 1 some,
or the file cannot be read, 2 wrong usage.

--fix removes repeated faces and those without area, welds, turns faces outwards, centres, scales to
fit (unless a project gives the distance) and moves colours that touch and cannot be separated apart
by the least that does; open edges stay. OUT.b holds all of that; OUT.ply, of meshes alone, keeps
the file's coordinates. A project's colours, camera and light are written into OUT.b.

Findings of one kind are one line with their count and the worst of them; --all prints each. They
are numbered, and --picture shows where they are: the object from the few views that show them best,
with the same numbers. What lies behind surfaces is dotted.

--merge-colours judges the mesh as it would be compiled with that option, and writes a picture of it
from three sides: as it is on the left, in its N colours on the right. --picture then names it.

Keys of --json:
  objects   object, surfaces, errors, warnings, notes, and findings: number (of its kind, as in text
            and picture), group (topology, placement, colours, visibility), code, severity (error,
            warning, note), message, cure, count, where (at most ten: triangles of a mesh as read
            or, of topology in a Bob scene and of all other groups, surfaces, from 1), can_fix,
            examples (message, count, where) of what it sums up, if anything, the worst first
  pictures  files written; only with --picture or --merge-colours
  fix       output, done (lines), colours (before, after, separation_before, separation_after; it
            separates above 1), left (OUT read again: as an object); only with --fix

Examples:
  aspectc doctor part.obj
  aspectc doctor part.obj --picture part.png
  aspectc doctor part.obj --fix part.b)";

// Why the command makes no sense; empty: it does.
std::string fault_of(const DoctorCommand& command, const std::vector<PreparedObject>& prepared) {
  if (!command.picture.empty() && prepared.size() != 1)
    return fmt::format("{}: has {} objects, and --picture names one file; leave it out",
                       command.file, prepared.size());
  if (command.fix.empty()) return {};
  const std::string extension = lower_extension(command.fix);
  if (prepared.size() != 1)
    return fmt::format("{}: has {} objects; --fix takes one", command.file, prepared.size());
  const PreparedObject& object = prepared.front();
  if (extension != ".b" && extension != ".ply")
    return fmt::format("{}: --fix writes .b or .ply; name it so", command.fix);
  if (extension == ".ply" && !is_mesh(object))
    return fmt::format("{}: a Bob scene is written as .b alone; name it so", command.fix);
  if (extension == ".ply" &&
      !(object.settings.mesh.colours.empty() && object.settings.surfaces.empty()))
    return fmt::format("{}: a project that colours the mesh is written as .b alone; name it so",
                       command.fix);
  std::error_code unknown;
  for (const std::filesystem::path& read : {object.scene_file, std::filesystem::path(command.file)})
    if (std::filesystem::equivalent(read, command.fix, unknown))
      return fmt::format("{} is both read and written; name another file", command.fix);
  return {};
}

// The object as it would be, were the file that was written in its place.
Result<PreparedObject> written_object(const PreparedObject& object, const std::string& file) {
  PreparedObject written{file, {}, object.settings};
  if (lower_extension(file) == ".b") {  // which holds these already
    written.settings.surfaces.clear();
    written.settings.light = {};
    written.settings.mesh.colours.clear();
  }
  Result<Scene> scene = read_scene(file);
  if (!scene) return Error{scene.error()};
  written.scene = std::move(scene).value();
  // A colour that stood in is written like any other, and is as wrong.
  written.scene.missing_colours = object.scene.missing_colours;
  if (auto done = apply_settings(written.settings, written.scene); !done)
    return Error{done.error()};
  return written;
}

Result<std::string> text_of(const Repair& repaired, const DoctorCommand& command) {
  if (lower_extension(command.fix) == ".ply") return ply_text(*repaired.mesh);
  return write_bob(repaired.scene);
}

Result<FixReport> fix(const PreparedObject& object, const DoctorCommand& command) {
  Result<Repair> repaired = repair(object);
  if (!repaired) return Error{repaired.error()};
  const Result<std::string> text = text_of(repaired.value(), command);
  if (!text) return Error{text.error()};
  const Result<Done> done = write_whole_text(command.fix, text.value());
  if (!done) return Error{done.error()};
  const Result<PreparedObject> written = written_object(object, command.fix);
  if (!written) return Error{written.error()};
  Result<Diagnosis> left = diagnose(written.value());
  if (!left) return Error{left.error()};
  return FixReport{command.fix, std::move(repaired.value().done), std::move(repaired.value().moves),
                   std::move(left).value()};
}

std::vector<GivenFlag> flags_of(const DoctorCommand& command) {
  if (command.merge_colours == 0) return {};
  return {{find_option("mesh", "merge_colours"), command.merge_colours}};
}

Result<Done> write_png(const std::string& file, const cv::Mat& picture) {
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", picture, png))
    return Error{file + ": the picture could not be encoded"};
  return write_whole_file(file, png);
}

// The object with what is wrong marked on it.
Result<DoctorReport::Shown> write_finding_picture(const DoctorCommand& command,
                                                  const PreparedObject& object,
                                                  const Diagnosis& diagnosis) {
  const std::vector<FindingLine> lines = finding_lines(diagnosis, command.all);
  const Result<FindingPicture> picture = finding_picture(object, diagnosis, lines);
  if (!picture) return Error{picture.error()};
  if (const auto done = write_png(command.picture, picture.value().picture); !done)
    return Error{done.error()};
  return DoctorReport::Shown{command.picture, "with the findings and their numbers"};
}

// The mesh as it is beside what becomes of it.
Result<DoctorReport::Shown> write_merging_picture(const DoctorCommand& command,
                                                  const PreparedObject& object) {
  CompileSettings unmerged = object.settings;
  unmerged.mesh.merge_colours.reset();
  const auto before = prepare_object({object.scene_file, object.scene.name, unmerged});
  if (!before) return Error{before.error()};
  const std::string file =
      command.picture.empty() ? object.scene.name + ".colours.png" : command.picture;
  if (const auto done = write_png(file, merging_picture(before.value().scene, object.scene)); !done)
    return Error{done.error()};
  return DoctorReport::Shown{file, "as it is on the left, in merged colours on the right"};
}

}  // namespace

CLI::App* add_doctor_command(CLI::App& app, DoctorCommand& command) {
  CLI::App* doctor =
      app.add_subcommand("doctor", "Tell what is wrong with a model, and how to cure it.");
  doctor->add_option("file", command.file, "scene, mesh, or project (.toml)")
      ->required()
      ->type_name("SCENE|FILE.toml");
  doctor->add_option("--fix", command.fix, "write the repaired model; .ply of a mesh only")
      ->type_name("FILE.b|FILE.ply");
  doctor
      ->add_option("--merge-colours", command.merge_colours,
                   "merge the colours of a mesh into so many, 2 to 256, and show it in "
                   "NAME.colours.png")
      ->type_name("N")
      ->check(CLI::Range(2, 256).description(""));
  doctor
      ->add_option("--picture", command.picture,
                   "show what is wrong, marked on the object, or what merging does")
      ->type_name("FILE.png");
  doctor->add_flag("--all", command.all, "a line for each finding and each example");
  doctor->add_flag("--json", command.json, "everything, as one JSON object");
  doctor->footer(kKeys);
  return doctor;
}

int run_doctor(const DoctorCommand& command) {
  const auto outcome = prepare_objects(command.file, flags_of(command), kUncoloured);
  if (const auto* error = std::get_if<PreparationError>(&outcome)) return fail(error->message);
  const auto& prepared = std::get<std::vector<PreparedObject>>(outcome);
  if (const std::string fault = fault_of(command, prepared); !fault.empty())
    return refuse_usage(fault);
  if (!command.picture.empty())
    if (const auto done = check_writable(command.picture); !done) return fail(done.error());
  DoctorReport report{command.file, {}, {}, {}};
  for (const PreparedObject& object : prepared) {
    for (const std::string& warning : object.scene.warnings) print_warning("aspectc", warning);
    Result<Diagnosis> diagnosis = diagnose(object);
    if (!diagnosis) return fail(diagnosis.error());
    report.objects.push_back(std::move(diagnosis).value());
  }
  for (std::size_t k = 0; k < prepared.size(); ++k) {
    if (command.merge_colours == 0 && command.picture.empty()) break;
    Result<DoctorReport::Shown> picture =
        command.merge_colours > 0 ? write_merging_picture(command, prepared[k])
                                  : write_finding_picture(command, prepared[k], report.objects[k]);
    if (!picture) return fail(picture.error());
    report.pictures.push_back(std::move(picture).value());
  }
  if (!command.fix.empty()) {
    Result<FixReport> fixed = fix(prepared.front(), command);
    if (!fixed) return fail(fixed.error());
    report.fix = std::move(fixed).value();
  }
  fmt::print("{}", command.json ? report_json(report)
                                : report_text(report, shows_colours(stdout), command.all));
  return report.is_healthy() ? 0 : 1;
}

}  // namespace aspect
