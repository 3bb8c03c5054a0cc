// aspectc on what it has compiled before.
#include <sys/inotify.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "tests/compiler/scene/mesh_samples.h"
#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;
using Words = std::vector<std::string>;

constexpr const char* kStudio = R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 128 128 antialias none threshold 1 aspect 1
         ambient 1 1 1 }
)";
constexpr const char* kFaces = R"(
surface { diffuse .8 .1 .1 }
polygon { points 4 vertex -.2 -.2 .2 vertex .2 -.2 .2 vertex .2 .2 .2 vertex -.2 .2 .2 }
surface { diffuse .1 .8 .1 }
polygon { points 4 vertex .2 -.2 -.2 vertex .2 .2 -.2 vertex .2 .2 .2 vertex .2 -.2 .2 }
)";
constexpr const char* kTwo = R"(
[subdivision]
level = 1
[[object]]
scene = "part.b"
[[object]]
scene = "part.b"
name = "blue"
[[object.surface]]
index = 0
diffuse = [0.1, 0.6, 0.8]
)";

void write_picture(const fs::path& file, const cv::Scalar& bgr) {
  REQUIRE(cv::imwrite(file, cv::Mat(8, 8, CV_8UC3, bgr)));
}

class Workplace : public TemporaryFolder {
 public:
  Workplace() {
    write("part.b", std::string("#include \"studio.bo\"\n") + kFaces);
    write("studio.bo", kStudio);
  }
  void write(const SampleFile& file) const { TemporaryFolder::write(file.name, file.bytes); }
  using TemporaryFolder::write;
  fs::path file(const std::string& name) const { return path() / name; }
  std::string read(const std::string& name) const { return read_file(file(name)); }

  // At a level that takes no time.
  Outcome run(Words words) const {
    words.insert(words.end(),
                 {"--level", "1", "--width", "128", "--height", "128", "--progress", "never",
                  "--small-cluster", "0", "--threshold", "1e9", "--cluster-threshold", "1e9"});
    return run_aspectc(path(), words);
  }
  // Whether it compiled, which it says as it says that it did not.
  bool compiles(const Words& words) const {
    const Outcome outcome = run(words);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    const bool compiled = outcome.out.find("classes cover") != std::string::npos;
    CHECK(compiled != (outcome.out.find("is up to date") != std::string::npos));
    return compiled;
  }
};

double least_ms(const Workplace& here, const Words& words) {
  double least = 1e9;
  for (int round = 0; round < 7; ++round) {
    const auto start = std::chrono::steady_clock::now();
    REQUIRE(here.run(words).exit_code == 0);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    least = std::min(least, time.count());
  }
  return least;
}

// The names in a folder that are opened while this lives, as the kernel sees it.
class OpenedFiles {
 public:
  explicit OpenedFiles(const fs::path& folder) : descriptor_(::inotify_init1(IN_NONBLOCK)) {
    REQUIRE(::inotify_add_watch(descriptor_, folder.c_str(), IN_OPEN) >= 0);
  }
  ~OpenedFiles() { ::close(descriptor_); }
  OpenedFiles(const OpenedFiles&) = delete;
  OpenedFiles& operator=(const OpenedFiles&) = delete;

  std::set<std::string> names() {
    alignas(inotify_event) std::array<char, 1 << 16> buffer{};
    for (ssize_t count; (count = ::read(descriptor_, buffer.data(), buffer.size())) > 0;)
      for (const char* next = buffer.data(); next < buffer.data() + count;) {
        const auto* event = reinterpret_cast<const inotify_event*>(next);
        if (event->len > 0) names_.insert(event->name);
        next += sizeof *event + event->len;
      }
    return names_;
  }

 private:
  int descriptor_;
  std::set<std::string> names_;
};

// A mesh with what it names, and one of these files in another state.
struct MeshCase {
  std::string scene, companion, changed;
};

std::vector<MeshCase> write_meshes(const Workplace& here) {
  here.write(cube_obj());
  here.write(cube_mtl());
  here.write(cube_gltf());
  here.write(cube_glb());
  here.write(cube_off(true));
  here.write(cube_dxf_faces(true));
  here.write(cube_ply("ascii", false));
  here.write(cube_binary_stl(true));
  std::string gltf = cube_gltf().bytes, glb = cube_glb().bytes;
  const std::size_t begin = gltf.find("data:application");
  gltf.replace(begin, gltf.find('"', begin) - begin, "outside.bin");
  const std::string buffer = glb.substr(glb.size() - 300);
  here.write("outside.gltf", gltf);
  here.write("outside.bin", buffer);
  write_picture(here.file("picture.png"), {40, 200, 40});
  write_picture(here.file("other.png"), {200, 40, 40});
  here.write("pictured.mtl", "newmtl a\nKd 1 1 1\nmap_Kd picture.png\n");
  here.write("pictured.obj",
             "mtllib pictured.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
             "usemtl a\nf 1/1 2/2 3/3\nf 1/1 2/2 4/3\n");
  here.write("textured.ply",
             "ply\nformat ascii 1.0\ncomment TextureFile picture.png\nelement vertex 4\n"
             "property float x\nproperty float y\nproperty float z\nproperty float s\n"
             "property float t\nelement face 2\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 0 1 0 1\n3 0 1 2\n3 0 1 3\n");
  here.write("mapped.b", std::string(kStudio) +
                             "surface { diffuse 1 1 1 texture { map "
                             "\"picture.png\" } }\nsphere { center 0 0 0 "
                             "radius .2 }\n");
  const std::string other = read_file(here.file("other.png"));
  const std::string mtl = cube_mtl().bytes;
  std::string moved = buffer;
  moved[3] = static_cast<char>(moved[3] ^ 1);
  return {{"part.b", "studio.bo", std::string(kStudio) + " "},
          {"mapped.b", "picture.png", other},
          {cube_obj().name, cube_mtl().name, "# later\n" + mtl},
          {"pictured.obj", "picture.png", other},
          {"textured.ply", "picture.png", other},
          {"outside.gltf", "outside.bin", moved},
          {cube_gltf().name, "", ""},
          {cube_glb().name, "", ""},
          {cube_off(true).name, "", ""},
          {cube_dxf_faces(true).name, "", ""},
          {cube_ply("ascii", false).name, "", ""},
          {cube_binary_stl(true).name, "", ""}};
}

// Whether the record of an index has a file by that name.
bool is_recorded(const Workplace& here, const std::string& index, const std::string& name) {
  return here.read(index + ".inputs").find(" " + name + "\n") != std::string::npos;
}

}  // namespace

TEST_CASE("a second run says that all is up to date, and writes nothing") {
  const Workplace here;
  REQUIRE(here.compiles({"part.b"}));
  const std::string index = here.read("part.aspect"), store = here.read("part.store");
  const auto made = fs::last_write_time(here.file("part.aspect"));
  const Outcome outcome = here.run({"part.b"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "part.aspect: is up to date, since its 2 files and the options are as they were; --force "
        "compiles all the same\n");
  CHECK(fs::last_write_time(here.file("part.aspect")) == made);
  CHECK(here.read("part.store") == store);
  CHECK(here.compiles({"part.b", "--force"}));
  CHECK(here.read("part.aspect") == index);
  CHECK_FALSE(here.compiles({"part.b"}));
}

TEST_CASE("a run with nothing to do takes 100 ms more than one that prints a version, at most") {
  const Workplace here;
  here.write(cube_obj());
  here.write(cube_mtl());
  for (const std::string& scene : {std::string("part.b"), cube_obj().name}) {
    REQUIRE(here.compiles({scene}));
    const double done_ms = least_ms(here, {scene}), version_ms = least_ms(here, {"--version"});
    INFO(done_ms << " against " << version_ms);
    CHECK(done_ms < version_ms + 100);
  }
}

TEST_CASE("every file that a run opens stands in its record, and whichever changes, it compiles") {
  const Workplace here;
  for (const MeshCase& mesh : write_meshes(here)) {
    INFO(mesh.scene);
    const std::string index = fs::path(mesh.scene).stem().string() + ".aspect";
    OpenedFiles opened(here.path());
    REQUIRE(here.compiles({mesh.scene, "--no-store", "--force"}));
    int companions = 0;
    for (const std::string& name : opened.names()) {
      if (name == "out" || name == "err" || name.starts_with(index)) continue;
      INFO(name);
      CHECK(is_recorded(here, index, name));
      companions += name == mesh.companion;
    }
    CHECK_FALSE(here.compiles({mesh.scene, "--no-store"}));
    std::vector<std::pair<std::string, std::string>> changes = {
        {mesh.scene, here.read(mesh.scene)}};
    if (!mesh.companion.empty()) {
      CHECK(companions == 1);
      changes.emplace_back(mesh.companion, here.read(mesh.companion));
      here.write(mesh.companion, mesh.changed);
      CHECK(here.compiles({mesh.scene, "--no-store"}));
    }
    for (const auto& [name, bytes] : changes) {
      here.write(name, bytes + "\n");
      CHECK(here.compiles({mesh.scene, "--no-store"}));
      here.write(name, bytes);
    }
  }
}

TEST_CASE("a material library that was missing and comes is a change") {
  const Workplace here;
  here.write(cube_obj());
  const Words grey = {cube_obj().name, "--no-store", "--missing-colour", "0.7,0.7,0.7"};
  REQUIRE(here.compiles(grey));
  CHECK_FALSE(here.compiles(grey));
  for (const std::string& name : {cube_mtl().name, std::string("CUBE.MTL")}) {
    here.write(name, cube_mtl().bytes);
    CHECK(here.compiles(grey));
    CHECK_FALSE(here.compiles(grey));
    fs::remove(here.file(name));
    CHECK(here.compiles(grey));
  }
}

TEST_CASE("what is touched is unchanged, and what is changed is so with the same size and time") {
  const Workplace here;
  REQUIRE(here.compiles({"part.b", "--no-store"}));
  const auto now = fs::file_time_type::clock::now();
  for (const char* name : {"part.b", "studio.bo", "part.aspect", "part.aspect.inputs"})
    fs::last_write_time(here.file(name), now);
  CHECK_FALSE(here.compiles({"part.b", "--no-store"}));
  std::string scene = here.read("part.b");
  scene.replace(scene.find(".8 .1 .1"), 8, ".1 .1 .8");
  here.write("part.b", scene);
  fs::last_write_time(here.file("part.b"), now);
  CHECK(here.compiles({"part.b", "--no-store"}));
}

TEST_CASE("an index that is gone, damaged or another's is made again") {
  const Workplace here;
  REQUIRE(here.compiles({"part.b"}));
  const std::string index = here.read("part.aspect");
  fs::remove(here.file("part.aspect"));
  CHECK(here.compiles({"part.b"}));
  for (const std::string& other : {index.substr(0, index.size() - 1), index + "x", std::string()}) {
    here.write("part.aspect", other);
    CHECK(here.compiles({"part.b"}));
    CHECK(here.read("part.aspect") == index);
    CHECK_FALSE(here.compiles({"part.b"}));
  }
}

TEST_CASE("without a sound record, or the store that is wanted, all is compiled") {
  const Workplace here;
  REQUIRE(here.compiles({"part.b", "--no-store"}));
  const std::string record = here.read("part.aspect.inputs");
  for (const std::string& other : {record.substr(0, record.size() - 1), std::string("none")}) {
    here.write("part.aspect.inputs", other);
    CHECK(here.compiles({"part.b", "--no-store"}));
    CHECK(here.read("part.aspect.inputs") == record);
  }
  fs::remove(here.file("part.aspect.inputs"));
  CHECK(here.compiles({"part.b", "--no-store"}));
  CHECK_FALSE(here.compiles({"part.b", "--no-store"}));
  CHECK(here.compiles({"part.b"}));
  CHECK_FALSE(here.compiles({"part.b"}));
  CHECK_FALSE(here.compiles({"part.b", "--no-store"}));
  fs::remove(here.file("part.store"));
  CHECK(here.compiles({"part.b"}));
  CHECK(here.compiles({"part.b", "--store", "another.store"}));
}

TEST_CASE("other options or another output compile, another number of threads does not") {
  const Workplace here;
  REQUIRE(here.compiles({"part.b", "--no-store"}));
  CHECK_FALSE(here.compiles({"part.b", "--no-store", "--jobs", "1"}));
  CHECK(here.compiles({"part.b", "--no-store", "-o", "other.aspect"}));
  CHECK(here.compiles({"part.b", "--no-store", "--types", "9"}));
  CHECK(here.compiles({"part.b", "--no-store"}));
  CHECK(here.compiles({"part.b", "--no-store", "--ambient", "1,1,0.5"}));
  CHECK(here.compiles({"part.b", "--no-store"}));
  CHECK_FALSE(here.compiles({"part.b", "--no-store"}));
  CHECK(here.compiles({"part.b", "--no-store", "--stats", "s.json"}));
  CHECK(fs::exists(here.file("s.json")));
}

TEST_CASE("another scene of the same name is another, be it as it may") {
  const Workplace here;
  fs::create_directory(here.file("sub"));
  here.write("sub/part.b", here.read("part.b"));
  here.write("sub/studio.bo", kStudio);
  REQUIRE(here.compiles({"part.b", "--no-store"}));
  CHECK(here.compiles({"sub/part.b", "--no-store"}));
  CHECK_FALSE(here.compiles({"./sub/part.b", "--no-store"}));
  CHECK_FALSE(here.compiles({here.file("sub/part.b"), "--no-store"}));
}

TEST_CASE("a folder that moves takes what is up to date along") {
  const Workplace here;
  fs::create_directory(here.file("from"));
  here.write("from/part.b", here.read("part.b"));
  here.write("from/studio.bo", kStudio);
  REQUIRE(here.compiles({"from/part.b", "-o", "from/part.aspect", "--no-store"}));
  fs::rename(here.file("from"), here.file("to"));
  CHECK_FALSE(here.compiles({"to/part.b", "-o", "to/part.aspect", "--no-store"}));
}

TEST_CASE("of a project's objects those that changed are compiled") {
  const Workplace here;
  here.write("two.toml", kTwo);
  REQUIRE(here.run({"two.toml"}).exit_code == 0);
  here.write("two.toml", std::string("# a remark\n") + kTwo);
  const Outcome same = here.run({"two.toml"});
  CHECK_THAT(same.out,
             StartsWith("part.aspect: is up to date") && Contains("\nblue.aspect: is up to date"));
  std::string other = kTwo;
  here.write("two.toml", other.replace(other.find("0.6"), 3, "0.5"));
  const Outcome blue = here.run({"two.toml", "--no-store"});
  CHECK_THAT(blue.out, StartsWith("part.aspect: is up to date") && Contains("\nblue.aspect: ") &&
                           Contains("classes cover"));
  CHECK(here.compiles({"two.toml", "--combined", "true", "--no-store"}));
  CHECK_FALSE(here.compiles({"two.toml", "--combined", "true", "--no-store"}));
  here.write("two.toml", kTwo);
  CHECK(here.compiles({"two.toml", "--combined", "true", "--no-store"}));
}

TEST_CASE("warnings are said again as long as they hold") {
  const Workplace here;
  here.write("p.toml", "scene = \"part.b\"\n[camera]\ndistance = [0.5, 30]\n");
  const Outcome first = here.run({"p.toml", "--no-store"});
  REQUIRE_THAT(first.err, Contains("aspectc: warning: part: the object leaves the picture"));
  CHECK(here.run({"p.toml", "--no-store"}).err == first.err);
}

TEST_CASE("a record is no other file's name, and one that cannot be written is a warning") {
  const Workplace here;
  const Outcome refused = here.run({"part.b", "--stats", "part.aspect.inputs"});
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Contains("part.aspect.inputs is given twice"));
  fs::create_directory(here.file("part.aspect.inputs"));
  const Outcome outcome = here.run({"part.b"});
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, StartsWith("aspectc: warning: part.aspect.inputs: cannot be written"));
  CHECK(here.compiles({"part.b"}));
}

}  // namespace aspect
