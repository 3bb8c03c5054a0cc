// Files that are cut off, changed or something else: one line, no crash.
#include <catch2/catch.hpp>
#include <random>

#include "compiler/scene/scene_reader.h"
#include "tests/compiler/step/step_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

bool require_scene_or_line(const std::filesystem::path& file) {
  const Result<Scene> scene = read_scene(file);
  if (scene.ok()) return true;
  REQUIRE(scene.error().find('\n') == std::string::npos);
  REQUIRE(scene.error().find(file.string()) == 0);
  return false;
}

}  // namespace

TEST_CASE("STEP files cut off or changed at random are read or refused in one line") {
  const TemporaryFolder folder;
  write_step_box(folder / "box.step", StepSchema::ap214);
  const std::string whole = read_file(folder / "box.step");
  std::mt19937 random(3);
  int refused = 0;
  for (int round = 0; round < 16; ++round) {
    std::string bytes = whole;
    if (round % 2 == 0)
      bytes.resize(bytes.size() * static_cast<std::size_t>(round) / 16 + 1);
    else
      for (int k = 0; k < 6 * round; ++k)
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    refused += !require_scene_or_line(folder.write("cut.step", bytes));
  }
  CHECK(refused > 6);
}

TEST_CASE("what is no STEP file is refused in one line") {
  const TemporaryFolder folder;
  std::mt19937 random(4);
  std::string noise(5000, ' ');
  for (char& letter : noise) letter = static_cast<char>(random() % 256);
  write_step_box(folder / "box.step", StepSchema::ap214);
  const std::string whole = read_file(folder / "box.step");
  std::string huge = whole;
  for (std::size_t at = 0; (at = huge.find("30.", at)) != std::string::npos; at += 6)
    huge.replace(at, 3, "1.E300");
  const std::string head = whole.substr(0, whole.find("DATA;"));
  for (const std::string& bytes : {noise, std::string("ISO-10303-21;"), head, huge,
                                   "solid a\n" + whole, head + "DATA;\nENDSEC;\nEND-ISO-10303-21;"})
    CHECK_FALSE(require_scene_or_line(folder.write("bad.stp", bytes)));
  const Result<Scene> empty = read_scene(folder.write("empty.step", ""));
  CHECK(empty.error().find("is empty; export it again") != std::string::npos);
}

}  // namespace aspect
