#include "compiler/scene/threemf_model.h"

#include <expat.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <memory>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

constexpr std::size_t kMostNameBytes = 80;

// Names without their namespaces: prefixes are the writer's choice.
std::string_view local_name(const char* name) {
  const std::string_view whole(name);
  const std::size_t bar = whole.rfind('|');
  return bar == std::string_view::npos ? whole : whole.substr(bar + 1);
}

class Attributes {
 public:
  explicit Attributes(const char** pairs) : pairs_(pairs) {}

  std::optional<std::string_view> text(std::string_view name) const {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2)
      if (local_name(pair[0]) == name) return std::string_view(pair[1]);
    return std::nullopt;
  }
  std::optional<std::uint32_t> whole(std::string_view name) const {
    const auto word = text(name);
    if (!word) return std::nullopt;
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(word->data(), word->data() + word->size(), value);
    if (error != std::errc() || end != word->data() + word->size() || value > 0x7fffffff)
      throw MeshError(
          fmt::format("{}=\"{}\" is no number from 0; export it again", name, shown(*word)));
    return value;
  }
  std::uint32_t needed(std::string_view name) const {
    const auto value = whole(name);
    if (!value) throw MeshError(fmt::format("{} is missing; export it again", name));
    return *value;
  }
  double number(std::string_view name) const { return number_in(text(name).value_or("")); }

  static double number_in(std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      throw MeshError(fmt::format("'{}' is not a finite number; export it again", shown(word)));
    return value;
  }

 private:
  const char** pairs_;
};

// "#RRGGBB" or "#RRGGBBAA" (3MF core 1.3, 3.4: sRGB).
Eigen::Vector3d colour_in(std::string_view text) {
  Eigen::Vector3d colour;
  const bool fits = (text.size() == 7 || text.size() == 9) && text.front() == '#';
  for (std::size_t k = 0; k < 3; ++k) {
    unsigned value = 0;
    const char* first = text.data() + 1 + 2 * k;
    if (!fits || std::from_chars(first, first + 2, value, 16).ptr != first + 2)
      throw MeshError(
          fmt::format("'{}' is no colour; write #RRGGBB and export it again", shown(text)));
    colour[static_cast<Eigen::Index>(k)] = value / 255.0;
  }
  return colour;
}

// Twelve numbers: the rows of a matrix that points, as rows, are multiplied by.
Eigen::Affine3d transform_in(std::string_view text) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.size() != 12) throw MeshError("a transform has not twelve numbers; export it again");
  Eigen::Affine3d placed = Eigen::Affine3d::Identity();
  for (std::size_t k = 0; k < 12; ++k)
    placed.matrix()(static_cast<Eigen::Index>(k % 3), static_cast<Eigen::Index>(k / 3)) =
        Attributes::number_in(words[k]);
  return placed;
}

double millimetres_in(std::string_view unit) {
  for (const auto& [name, length] : {std::pair<std::string_view, double>{"micron", .001},
                                     {"millimeter", 1},
                                     {"centimeter", 10},
                                     {"inch", 25.4},
                                     {"foot", 304.8},
                                     {"meter", 1000}})
    if (unit == name) return length;
  throw MeshError(fmt::format("unit \"{}\" is unknown; use millimeter", shown(unit)));
}

ThreeMfInstance instance_in(const Attributes& attributes) {
  ThreeMfInstance instance;
  instance.object = attributes.needed("objectid");
  instance.part = attributes.text("path").value_or("");
  if (const auto text = attributes.text("transform")) instance.placed = transform_in(*text);
  return instance;
}

class ModelReader {
 public:
  void begin(std::string_view element, const Attributes& attributes) {
    if (element == "model") {
      model.millimetres = millimetres_in(attributes.text("unit").value_or("millimeter"));
    } else if (element == "basematerials" || element == "colorgroup" ||
               element == "texture2dgroup" || element == "compositematerials" ||
               element == "multiproperties") {
      properties_ = &model.properties[attributes.needed("id")];
      properties_->kind = element;
    } else if (element == "base" && properties_ != nullptr) {
      properties_->names.emplace_back(
          attributes.text("name").value_or("").substr(0, kMostNameBytes));
      properties_->colours.push_back(colour_in(attributes.text("displaycolor").value_or("")));
    } else if (element == "color" && properties_ != nullptr) {
      properties_->colours.push_back(colour_in(attributes.text("color").value_or("")));
    } else if (element == "object") {
      begin_object(attributes);
    } else if (element == "item") {
      model.items.push_back(instance_in(attributes));
    } else if (object_ != nullptr) {
      add_to_object(element, attributes);
    }
  }
  void end(std::string_view element) {
    if (element == "object") object_ = nullptr;
    if (element == "basematerials" || element == "colorgroup") properties_ = nullptr;
  }

  ThreeMfModel model;

 private:
  void begin_object(const Attributes& attributes) {
    const std::uint32_t id = attributes.needed("id");
    object_ = &model.objects[id];
    const std::string_view name = attributes.text("name").value_or("");
    object_->name =
        name.empty() ? fmt::format("object {}", id) : std::string(name.substr(0, kMostNameBytes));
    const std::string_view type = attributes.text("type").value_or("model");
    object_->is_model = type == "model" || type == "solidsupport";
    object_->properties = attributes.whole("pid");
    object_->place = attributes.whole("pindex");
  }

  void add_to_object(std::string_view element, const Attributes& attributes) {
    if (element == "vertex") {
      if (++vertices_ > ColouredMesh::kMaxVertices)
        throw MeshError(
            fmt::format("more than {} vertices; simplify the model", ColouredMesh::kMaxVertices));
      object_->vertices.emplace_back(attributes.number("x"), attributes.number("y"),
                                     attributes.number("z"));
    } else if (element == "triangle") {
      if (++triangles_ > ColouredMesh::kMaxTriangles)
        throw MeshError(
            fmt::format("more than {} triangles; simplify the model", ColouredMesh::kMaxTriangles));
      ThreeMfTriangle triangle;
      triangle.corners = {attributes.needed("v1"), attributes.needed("v2"),
                          attributes.needed("v3")};
      triangle.properties = attributes.whole("pid");
      triangle.place = {attributes.whole("p1"), attributes.whole("p2"), attributes.whole("p3")};
      object_->triangles.push_back(triangle);
    } else if (element == "component") {
      object_->components.push_back(instance_in(attributes));
    }
  }

  ThreeMfProperties* properties_ = nullptr;
  ThreeMfObject* object_ = nullptr;
  std::size_t vertices_ = 0, triangles_ = 0;
};

using Begin = std::function<void(std::string_view, const Attributes&)>;
using End = std::function<void(std::string_view)>;

// Exceptions must not cross the library, which is C.
struct Reading {
  const Begin& begin;
  const End& end;
  XML_Parser parser = nullptr;
  std::optional<MeshError> failure = std::nullopt;

  void guard(const std::function<void()>& action) {
    if (failure) return;
    try {
      action();
    } catch (const MeshError& error) {
      failure.emplace(error.what());
    } catch (const std::bad_alloc&) {
      failure.emplace("needs more memory than there is; simplify the model");
    }
    if (failure) XML_StopParser(parser, XML_FALSE);
  }
};

void on_begin(void* user, const char* name, const char** attributes) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guard([&] { reading.begin(local_name(name), Attributes(attributes)); });
}
void on_end(void* user, const char* name) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guard([&] { reading.end(local_name(name)); });
}
// The standard forbids it, and entities are for attacks.
void on_doctype(void* user, const char*, const char*, const char*, int) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guard([] { throw MeshError("has a DOCTYPE, which 3MF forbids; export it again"); });
}

void read_xml(std::string_view xml, const std::string& part, const Begin& begin, const End& end) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(
      XML_ParserCreateNS(nullptr, '|'), XML_ParserFree);
  Reading reading{begin, end, parser.get()};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), on_begin, on_end);
  XML_SetStartDoctypeDeclHandler(parser.get(), on_doctype);
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  for (bool last = false; !last;) {
    const std::string_view piece = xml.substr(0, kPiece);
    xml.remove_prefix(piece.size());
    last = xml.empty();
    if (XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), last ? 1 : 0) !=
        XML_STATUS_ERROR)
      continue;
    throw MeshError(fmt::format(
        "{} line {}: {}", part, XML_GetCurrentLineNumber(parser.get()),
        reading.failure
            ? std::string(reading.failure->what())
            : fmt::format("{}; export it again", XML_ErrorString(XML_GetErrorCode(parser.get())))));
  }
}

}  // namespace

ThreeMfModel parse_threemf_model(std::string_view xml, const std::string& part) {
  ModelReader reader;
  read_xml(
      xml, part,
      [&](std::string_view element, const Attributes& attributes) {
        reader.begin(element, attributes);
      },
      [&](std::string_view element) { reader.end(element); });
  return std::move(reader.model);
}

std::string root_model_of(std::string_view relationships) {
  std::string found;
  read_xml(
      relationships, "_rels/.rels",
      [&](std::string_view element, const Attributes& attributes) {
        const std::string_view type = attributes.text("Type").value_or("");
        if (element == "Relationship" && type.ends_with("/3dmodel") && found.empty())
          found = attributes.text("Target").value_or("");
      },
      [](std::string_view) {});
  return found;
}

}  // namespace aspect
