#include "compiler/scene/mtl_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/scene/mesh_text.h"
#include "compiler/scene/srgb.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Words = std::vector<std::string_view>;

constexpr std::size_t kMostMaterials = 100'000;

struct MapOption {
  std::string_view name;
  std::size_t least, most;  // of the words behind it
};
constexpr std::array<MapOption, 14> kMapOptions = {{{"-blendu", 1, 1},
                                                    {"-blendv", 1, 1},
                                                    {"-bm", 1, 1},
                                                    {"-boost", 1, 1},
                                                    {"-cc", 1, 1},
                                                    {"-clamp", 1, 1},
                                                    {"-colorspace", 1, 1},
                                                    {"-imfchan", 1, 1},
                                                    {"-mm", 2, 2},
                                                    {"-o", 1, 3},
                                                    {"-s", 1, 3},
                                                    {"-t", 1, 3},
                                                    {"-texres", 1, 1},
                                                    {"-type", 1, 1}}};

bool is_number(std::string_view word) {
  return word.find_first_not_of("+-.0123456789eE") == std::string_view::npos &&
         word.find_first_of("0123456789") != std::string_view::npos;
}

class MtlReader {
 public:
  MtlReader(std::string_view text, const std::filesystem::path& file, MtlMaterials& materials,
            std::vector<std::string>& warnings)
      : text_(text), file_(file), materials_(materials), warnings_(warnings) {}

  void read() {
    while (!text_.at_end()) {
      const std::string_view line = text_.take_line();
      const Words words = words_of(line);
      if (words.empty() || words[0].starts_with('#')) continue;
      const std::string keyword = lower_case(words[0]);
      if (keyword == "newmtl")
        begin(rest_of_line(line, words[0]));
      else if (material_ != nullptr && keyword == "kd")
        read_colour(words_of(line.substr(0, line.find('#'))));
      else if (material_ != nullptr && keyword == "map_kd")
        read_picture(line, words);
    }
  }

 private:
  void begin(std::string_view name) {
    if (name.empty()) text_.fail("newmtl without a name; name the material");
    if (materials_.size() == kMostMaterials)
      text_.fail(fmt::format("more than {} materials; write fewer", kMostMaterials));
    material_ = &materials_[std::string(name)];
    material_->library = file_;
  }

  void read_colour(Words words) {
    words.erase(words.begin());
    material_->colour_line = text_.line();
    material_->colour.reset();
    if (!words.empty() && words[0] == "spectral") {
      material_->unread = "a spectral curve";
      return;
    }
    const bool xyz = !words.empty() && words[0] == "xyz";
    if (xyz) words.erase(words.begin());
    if (words.size() != 1 && words.size() < 3)
      text_.fail(fmt::format("Kd of {} numbers; write Kd r g b", words.size()));
    Vector3d colour = Vector3d::Constant(text_.number(words[0]));
    if (words.size() > 1) colour = {colour.x(), text_.number(words[1]), text_.number(words[2])};
    if (!xyz && colour.maxCoeff() > 1)
      warnings_.push_back(fmt::format("{}:{}: Kd is above 1 and cut off there; write parts of 1",
                                      file_.string(), text_.line()));
    material_->colour = xyz ? srgb_of_xyz(colour) : colour;
  }

  void read_picture(std::string_view line, const Words& words) {
    std::size_t next = 1;
    while (next < words.size()) {
      const auto* const option =
          std::find_if(kMapOptions.begin(), kMapOptions.end(),
                       [&](const MapOption& known) { return known.name == words[next]; });
      if (option == kMapOptions.end()) break;
      const std::size_t first = next + 1;
      std::size_t count = option->least;
      while (count < option->most && first + count < words.size() &&
             is_number(words[first + count]))
        ++count;
      if (first + count >= words.size())
        text_.fail(fmt::format("{} ends where the picture's name should be", words[next]));
      if (option->name == "-s")
        material_->picture_scale = pair_of(words, first, count, 1);
      else if (option->name == "-o")
        material_->picture_offset = pair_of(words, first, count, 0);
      next = first + count;
    }
    if (next >= words.size()) text_.fail("map_Kd without a picture; name it");
    material_->picture = rest_of_line(line, words[next - 1]);
    material_->picture_line = text_.line();
  }

  Vector2d pair_of(const Words& words, std::size_t first, std::size_t count, double absent) const {
    return {text_.number(words[first]), count > 1 ? text_.number(words[first + 1]) : absent};
  }

  MeshText text_;
  const std::filesystem::path& file_;
  MtlMaterials& materials_;
  std::vector<std::string>& warnings_;
  MtlMaterial* material_ = nullptr;
};

}  // namespace

void read_mtl(std::string_view text, const std::filesystem::path& file, MtlMaterials& materials,
              std::vector<std::string>& warnings) {
  std::string held;
  try {
    MtlReader(with_line_feeds(without_byte_order_mark(text), held), file, materials, warnings)
        .read();
  } catch (const MeshError& error) {
    throw MeshError(error.what(), error.line(), file.string());
  }
}

}  // namespace aspect
