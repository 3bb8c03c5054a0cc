#include "tools/aspectc/commands/doctor_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>

#include "compiler/scene/bob_writer.h"
#include "compiler/scene/scene_reader.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/aspectc/project/scene_settings.h"
#include "tools/command_line/command_line.h"
#include "tools/doctor/report.h"

namespace aspect {
namespace {

constexpr const char* kKeys =
    R"(Exit code: 0 no error and no warning (notes are allowed; with --fix: none is left), 1 some or
FILE cannot be read, 2 usage.
--fix removes repeated faces and those without area, welds, turns faces outwards, centres, scales to
fit (unless a project gives the distance) and moves colours that touch and cannot be separated apart
by the least that does; open edges stay. OUT.b holds all of that; OUT.ply, of meshes alone, keeps
the file's coordinates. A project's colours, camera and light are written into OUT.b.
Keys of --json:
  objects   object, surfaces, errors, warnings, notes, and findings: group (topology, placement,
            colours, visibility), code, severity (error, warning, note), message, cure, count,
            where (at most ten: triangles of a mesh as read or, of topology in a Bob scene and of
            all other groups, surfaces, from 1), can_fix
  fix       output, done (lines), colours (before, after, separation_before, separation_after; it
            separates above 1), left (OUT read again: as an object); only with --fix)";

int refuse_usage(const std::string& message) {
  fail(message);
  return kUsageError;
}

// Why the command makes no sense; empty: it does.
std::string fault_of(const DoctorCommand& command, const PreparedObjects& prepared) {
  if (command.fix.empty()) return {};
  const std::string extension = lower_extension(command.fix);
  if (prepared.objects.size() != 1)
    return fmt::format("{}: has {} objects; --fix takes one", command.file,
                       prepared.objects.size());
  const PreparedObject& object = prepared.objects.front();
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
    written.settings.mesh = {};
  }
  Result<Scene> scene = read_scene(file);
  if (!scene) return Error{scene.error()};
  written.scene = std::move(scene).value();
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
  const auto* first = reinterpret_cast<const std::uint8_t*>(text.value().data());
  const Result<Done> done = write_whole_file(command.fix, {first, text.value().size()});
  if (!done) return Error{done.error()};
  const Result<PreparedObject> written = written_object(object, command.fix);
  if (!written) return Error{written.error()};
  Result<Diagnosis> left = diagnose(written.value());
  if (!left) return Error{left.error()};
  return FixReport{command.fix, std::move(repaired.value().done), std::move(repaired.value().moves),
                   std::move(left).value()};
}

}  // namespace

CLI::App* add_doctor_command(CLI::App& app, DoctorCommand& command) {
  CLI::App* doctor =
      app.add_subcommand("doctor", "Tell what is wrong with a model, and how to cure it.");
  doctor->add_option("file", command.file, "scene, mesh, or project (.toml)")->required();
  doctor->add_option("--fix", command.fix, "write the repaired model (.b, or .ply of a mesh)");
  doctor->add_flag("--json", command.json, "everything, as one JSON object");
  doctor->footer(kKeys);
  return doctor;
}

int run_doctor(const DoctorCommand& command) {
  const auto outcome = prepare_objects(command.file, {});
  if (const auto* error = std::get_if<PreparationError>(&outcome)) return fail(error->message);
  const auto& prepared = std::get<PreparedObjects>(outcome);
  if (const std::string fault = fault_of(command, prepared); !fault.empty())
    return refuse_usage(fault);
  DoctorReport report{command.file, {}, {}};
  for (const PreparedObject& object : prepared.objects) {
    for (const std::string& warning : object.scene.warnings)
      fmt::print(stderr, "aspectc: warning: {}\n", warning);
    Result<Diagnosis> diagnosis = diagnose(object);
    if (!diagnosis) return fail(diagnosis.error());
    report.objects.push_back(std::move(diagnosis).value());
  }
  if (!command.fix.empty()) {
    Result<FixReport> fixed = fix(prepared.objects.front(), command);
    if (!fixed) return fail(fixed.error());
    report.fix = std::move(fixed).value();
  }
  fmt::print("{}", command.json ? report_json(report) : report_text(report));
  return report.is_healthy() ? 0 : 1;
}

}  // namespace aspect
