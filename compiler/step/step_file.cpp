// A STEP file as coloured triangles.
//
// Steps: OpenCASCADE reads the file into a tree of labels: assemblies of placed instances of
// products, which are shapes; faces, solids and so on that have a name or a colour have labels
// below their product's. The tree is walked once to list the placed faces with their names and
// colours; the products are cut into triangles, once each; the triangles of the listed faces are
// placed.
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <NCollection_DataMap.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <fmt/format.h>

#include <map>

#include "compiler/scene/step_mesh.h"
#include "compiler/step/step_colours.h"

namespace aspect {
namespace {

constexpr double kAngle = 0.35;  // radians between neighbouring triangles: 18 sides of any hole
// OpenCASCADE keeps what it is asked along edges, not within faces: measured on a ball, up to 1.8
// times that. So it is measured, and asked for less until it holds.
constexpr int kMostRounds = 4;
constexpr int kMaxDepth = 64;  // of assemblies in each other
constexpr std::size_t kMaxFaces = 1'000'000, kMaxNameBytes = 100;
constexpr std::size_t kMostMissing = 100;  // told one by one
constexpr const char* kCure =
    "colour every face in the CAD program and export it as AP214 or AP242 with colours, or give "
    "colours by face or body under [mesh] colours in a project";

// Nothing where the file has none, or what programs write that have none.
std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return {};
  const TCollection_AsciiString text(attribute->Get());  // UTF-8
  std::string name;
  for (const char letter : std::string_view(text.ToCString()).substr(0, kMaxNameBytes))
    name += static_cast<unsigned char>(letter) < ' ' || letter == '\x7f' ? '?' : letter;
  const auto first = name.find_first_not_of(' ');
  if (first == std::string::npos || name == "NONE") return {};
  return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

// What is known of a shape from what it is a part of.
struct Inherited {
  std::string name;
  StepColour colour;
};

struct PlacedFace {
  TopoDS_Face face;  // without the placement
  gp_Trsf placement;
  std::string name, body;
  StepColour colour;
};

// Labels of faces, solids and so on of a product.
using LabelOfShape = NCollection_DataMap<TopoDS_Shape, TDF_Label, TopTools_ShapeMapHasher>;

class StepTree {
 public:
  explicit StepTree(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

  void walk() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (int k = 1; k <= roots.Length(); ++k) {
      if (!colours_->IsVisible(roots.Value(k)))
        ++hidden;
      else
        add_product(roots.Value(k), {}, {}, {});
    }
  }

  std::vector<PlacedFace> faces;
  std::vector<TopoDS_Shape> products;  // that have faces
  std::size_t hidden = 0;

 private:
  // `path`: the instances around it, the outermost first.
  void add_product(const TDF_Label& label, const gp_Trsf& placement, const TDF_LabelSequence& path,
                   const Inherited& outer) {
    if (path.Length() > kMaxDepth)
      throw MeshError(
          fmt::format("assemblies are nested more than {} deep; flatten it", kMaxDepth));
    Inherited inherited{name_of(label), outer.colour};
    if (const StepColour own = colour_of(label)) inherited.colour = own;
    if (const StepColour of_instance = instance_colour(path)) inherited.colour = of_instance;
    if (inherited.name.empty()) inherited.name = outer.name;
    if (!XCAFDoc_ShapeTool::IsAssembly(label)) return add_bodies(label, placement, inherited);
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (int k = 1; k <= components.Length(); ++k) {
      const TDF_Label& component = components.Value(k);
      TDF_Label product;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, product)) continue;
      if (!colours_->IsVisible(component) || !colours_->IsVisible(product)) {
        ++hidden;
        continue;
      }
      TDF_LabelSequence inner = path;
      inner.Append(component);
      add_product(product, placement * XCAFDoc_ShapeTool::GetLocation(component).Transformation(),
                  inner, {name_of(component), inherited.colour});
    }
  }

  void add_bodies(const TDF_Label& product, const gp_Trsf& placement, const Inherited& inherited) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    if (shape.IsNull()) return;
    LabelOfShape labels;
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(product, parts);
    for (int k = 1; k <= parts.Length(); ++k)
      labels.Bind(XCAFDoc_ShapeTool::GetShape(parts.Value(k)), parts.Value(k));
    const std::size_t before = faces.size();
    std::map<std::string, std::size_t> faces_of_body;
    const std::string name = inherited.name.empty() ? "body" : inherited.name;
    add_shape(shape, placement, labels, {name, inherited.colour}, faces_of_body, 0);
    if (faces.size() > before) products.push_back(shape);
  }

  void add_shape(const TopoDS_Shape& shape, const gp_Trsf& placement, const LabelOfShape& labels,
                 Inherited inherited, std::map<std::string, std::size_t>& faces_of_body,
                 int depth) {
    if (depth > kMaxDepth)
      throw MeshError(fmt::format("shapes are nested more than {} deep; flatten it", kMaxDepth));
    std::string name;
    if (const TDF_Label* label = labels.Seek(shape)) {
      if (!colours_->IsVisible(*label)) {
        ++hidden;
        return;
      }
      if (const StepColour own = colour_of(*label)) inherited.colour = own;
      name = name_of(*label);
    }
    if (shape.ShapeType() == TopAbs_FACE) {
      if (faces.size() == kMaxFaces)
        throw MeshError(fmt::format("more than {} faces; simplify the model", kMaxFaces));
      const std::size_t number = ++faces_of_body[inherited.name];
      if (name.empty()) name = fmt::format("{}.face {}", inherited.name, number);
      faces.push_back({TopoDS::Face(shape), placement, name, inherited.name, inherited.colour});
      return;
    }
    if (!name.empty() && shape.ShapeType() != TopAbs_SHELL) inherited.name = name;
    for (TopoDS_Iterator inner(shape); inner.More(); inner.Next())
      if (inner.Value().ShapeType() <= TopAbs_FACE)
        add_shape(inner.Value(), placement, labels, inherited, faces_of_body, depth + 1);
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
};

Eigen::Vector3d point_of(gp_Pnt point, const gp_Trsf& placement) {
  point.Transform(placement);
  return {point.X(), point.Y(), point.Z()};
}

// The triangles of what was cut so far; nothing for a face that could not be.
std::size_t add_triangles(const std::vector<PlacedFace>& faces, const Eigen::Vector3d& stand_in,
                          ColouredMesh& mesh) {
  std::size_t lost = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const PlacedFace& placed = faces[k];
    TopLoc_Location within;
    const Handle(Poly_Triangulation) cut = BRep_Tool::Triangulation(placed.face, within);
    if (cut.IsNull()) {
      ++lost;
      continue;
    }
    const gp_Trsf all = placed.placement * within.Transformation();
    const bool turned = (placed.face.Orientation() == TopAbs_REVERSED) != all.IsNegative();
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    if (mesh.triangles.size() + static_cast<std::size_t>(cut->NbTriangles()) >
            ColouredMesh::kMaxTriangles ||
        mesh.vertices.size() + static_cast<std::size_t>(cut->NbNodes()) >
            ColouredMesh::kMaxVertices)
      throw MeshError(
          fmt::format("more than {} triangles; raise --chord-error", ColouredMesh::kMaxTriangles));
    for (int node = 1; node <= cut->NbNodes(); ++node)
      mesh.vertices.push_back(point_of(cut->Node(node), all));
    for (int t = 1; t <= cut->NbTriangles(); ++t) {
      int a = 0, b = 0, c = 0;
      cut->Triangle(t).Get(a, b, c);
      if (turned) std::swap(b, c);
      const auto corner = [&](int node) { return first + static_cast<std::uint32_t>(node - 1); };
      mesh.triangles.push_back({corner(a), corner(b), corner(c)});
      mesh.colours.push_back(placed.colour.value_or(stand_in));
      mesh.part_of.push_back(static_cast<std::uint32_t>(k));
    }
  }
  return lost;
}

void cut_into_triangles(const std::vector<TopoDS_Shape>& products, double error_mm) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = error_mm;
  parameters.Angle = kAngle;
  parameters.InParallel = Standard_False;
  parameters.AllowQualityDecrease = Standard_True;  // what was cut finer is cut again
  for (const TopoDS_Shape& product : products) BRepMesh_IncrementalMesh(product, parameters);
}

double diagonal_of(const std::vector<PlacedFace>& faces) {
  Bnd_Box box;
  for (const PlacedFace& placed : faces) {
    Bnd_Box own;
    BRepBndLib::Add(placed.face, own, Standard_False);
    if (!own.IsVoid()) box.Add(own.Transformed(placed.placement));
  }
  if (box.IsVoid() || box.IsOpen()) throw MeshError("has no size; export solids with faces");
  box.SetGap(0);
  return std::sqrt(box.SquareExtent());
}

double diagonal_of(const ColouredMesh& mesh) {
  Eigen::Vector3d least = mesh.vertices.front(), most = least;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    least = least.cwiseMin(vertex);
    most = most.cwiseMax(vertex);
  }
  return (most - least).norm();
}

void note_missing(const std::vector<PlacedFace>& faces, ColouredMesh& mesh) {
  std::vector<std::uint32_t> lacking;
  for (std::uint32_t k = 0; k < faces.size(); ++k)
    if (!faces[k].colour) lacking.push_back(k);
  const std::string all = lacking.size() == faces.size() ? "holds no colours: " : "";
  for (std::size_t k = 0; k < std::min(lacking.size(), kMostMissing); ++k)
    mesh.missing.push_back(
        {{},
         0,
         fmt::format("{}face '{}' of '{}' has none", all.empty() ? "lacks a colour: " : all,
                     faces[lacking[k]].name, faces[lacking[k]].body),
         kCure,
         {lacking[k]}});
  if (lacking.size() <= kMostMissing) return;
  lacking.erase(lacking.begin(), lacking.begin() + kMostMissing);
  const std::size_t more = lacking.size();
  mesh.missing.push_back(
      {{}, 0, fmt::format("lacks colours of {} more faces", more), kCure, std::move(lacking)});
}

Handle(TDocStd_Document) read_document(const char* file, ColouredMesh& mesh) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPCAFControl_Reader reader;
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  reader.SetPropsMode(Standard_False);
  reader.SetGDTMode(Standard_False);
  reader.SetMatMode(Standard_False);
  reader.SetViewMode(Standard_False);
  reader.SetSHUOMode(Standard_True);
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(file) != IFSelect_RetDone)
    throw MeshError("is no STEP file, or is cut off; export it again");
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  if (!reader.Transfer(document))
    throw MeshError("holds no shapes that can be read; export solids as AP214 or AP242");
  for (NCollection_DataMap<TCollection_AsciiString, Handle(STEPCAFControl_ExternFile)>::Iterator
           other(reader.ExternFiles());
       other.More(); other.Next())
    mesh.files.push_back(
        (std::filesystem::path(file).parent_path() / other.Key().ToCString()).string());
  return document;
}

// The largest distance of a triangle's middle, and of those of its sides, from the surface; seen
// along the surface's normal there, as parameters do not grow evenly.
double error_of(const TopoDS_Face& face) {
  TopLoc_Location within;
  const Handle(Poly_Triangulation) cut = BRep_Tool::Triangulation(face, within);
  if (cut.IsNull() || !cut->HasUVNodes()) return 0;
  const BRepAdaptor_Surface surface(face);
  if (surface.GetType() == GeomAbs_Plane) return 0;
  double worst = 0;
  const auto look = [&](std::initializer_list<int> nodes) {
    gp_XYZ point(0, 0, 0);
    gp_XY place(0, 0);
    for (const int node : nodes) {
      point += cut->Node(node).Transformed(within.Transformation()).XYZ() /
               static_cast<double>(nodes.size());
      place += cut->UVNode(node).XY() / static_cast<double>(nodes.size());
    }
    gp_Pnt on;
    gp_Vec along_u, along_v;
    surface.D1(place.X(), place.Y(), on, along_u, along_v);
    const gp_Vec normal = along_u.Crossed(along_v);
    if (normal.Magnitude() < 1e-12) return;
    worst = std::max(worst, std::abs(gp_Vec(on.XYZ() - point).Dot(normal.Normalized())));
  };
  for (int t = 1; t <= cut->NbTriangles(); ++t) {
    int a = 0, b = 0, c = 0;
    cut->Triangle(t).Get(a, b, c);
    look({a, b, c});
    look({a, b});
    look({b, c});
    look({c, a});
  }
  return worst;
}

double error_of(const std::vector<PlacedFace>& faces) {
  double worst = 0;
  for (const PlacedFace& placed : faces) worst = std::max(worst, error_of(placed.face));
  return worst;
}

void cut_within(const StepTree& tree, double error_mm) {
  double asked = error_mm;
  for (int round = 0; round < kMostRounds; ++round, asked /= 2) {
    cut_into_triangles(tree.products, asked);
    if (error_of(tree.faces) <= error_mm) return;
  }
}

void read_file(const char* file, const StepReading& reading, ColouredMesh& mesh) {
  const Handle(TDocStd_Document) document = read_document(file, mesh);
  StepTree tree(document);
  tree.walk();
  if (tree.faces.empty())
    throw MeshError(tree.hidden > 0 ? "holds nothing visible; show its bodies and export it again"
                                    : "holds no faces; export solids as AP214 or AP242");
  // Boxes around free-form surfaces can be too large, those around their triangles are not.
  const double guessed = diagonal_of(tree.faces);
  cut_within(tree, reading.chord_error * guessed);
  std::size_t lost = add_triangles(tree.faces, reading.stand_in, mesh);
  if (mesh.triangles.empty()) throw MeshError("no face can be cut into triangles; export a mesh");
  if (const double actual = diagonal_of(mesh); actual < 0.95 * guessed) {
    mesh.vertices.clear();
    mesh.triangles.clear();
    mesh.colours.clear();
    mesh.part_of.clear();
    cut_within(tree, reading.chord_error * actual);
    lost = add_triangles(tree.faces, reading.stand_in, mesh);
  }
  for (const PlacedFace& placed : tree.faces) mesh.parts.push_back({placed.name, placed.body});
  note_missing(tree.faces, mesh);
  if (lost > 0)
    mesh.warnings.push_back(fmt::format(
        "{} of {} faces cannot be cut into triangles and are left out", lost, tree.faces.size()));
  if (tree.hidden > 0)
    mesh.warnings.push_back(
        fmt::format("{} invisible bodies, instances or faces are left out", tree.hidden));
}

}  // namespace
}  // namespace aspect

extern "C" void aspect_read_step_file(const char* file, const aspect::StepReading& reading,
                                      aspect::ColouredMesh& mesh) {
  try {
    aspect::read_file(file, reading, mesh);
  } catch (const Standard_Failure& failure) {  // no std::exception in 7.6
    throw aspect::MeshError(
        fmt::format("cannot be read ({}); export it again", failure.DynamicType()->Name()));
  }
}
