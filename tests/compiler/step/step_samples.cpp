#include "tests/compiler/step/step_samples.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <stdexcept>

namespace aspect {
namespace {

using Eigen::Vector3d;

class StepDocument {
 public:
  TDF_Label add(const TopoDS_Shape& shape, const char* name) {
    const TDF_Label label = shapes()->AddShape(shape, Standard_False);
    TDataStd_Name::Set(label, name);
    return label;
  }
  TDF_Label add_part(const TDF_Label& product, const TopoDS_Shape& shape, const char* name) {
    const TDF_Label label = shapes()->AddSubShape(product, shape);
    if (*name != '\0') TDataStd_Name::Set(label, name);
    return label;
  }
  void paint(const TDF_Label& label, const Vector3d& colour) {
    colours()->SetColor(label,
                        Quantity_Color(colour.x(), colour.y(), colour.z(), Quantity_TOC_sRGB),
                        XCAFDoc_ColorSurf);
  }
  Handle(XCAFDoc_ShapeTool) shapes() { return XCAFDoc_DocumentTool::ShapeTool(document_->Main()); }
  Handle(XCAFDoc_ColorTool) colours() { return XCAFDoc_DocumentTool::ColorTool(document_->Main()); }

  // In a process of its own: what a file in inches leaves in OpenCASCADE changes later ones.
  void write(const std::filesystem::path& file, StepSchema schema, const std::string& unit) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(write_here(file, schema, unit) ? 0 : 1);
    int status = 1;
    ::waitpid(child, &status, 0);
    if (status != 0) throw std::runtime_error("OpenCASCADE did not write " + file.string());
  }

 private:
  bool write_here(const std::filesystem::path& file, StepSchema schema, const std::string& unit) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Controller::Init();
    const char* schemas[] = {"AP203", "AP214IS", "AP242DIS"};
    STEPCAFControl_Writer writer;
    Interface_Static::SetCVal("write.step.schema", schemas[static_cast<int>(schema)]);
    Interface_Static::SetCVal("write.step.unit", unit.c_str());
    Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
    return writer.Transfer(document_) && writer.Write(file.c_str()) == IFSelect_RetDone;
  }

  Handle(TDocStd_Document) document_ = new TDocStd_Document("XmlXCAF");
};

gp_Trsf moved(double x, double y, double z) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(x, y, z));
  return move;
}

std::vector<TopoDS_Shape> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    faces.push_back(face.Current());
  return faces;
}

}  // namespace

std::vector<BoxFace> box_faces() {
  return {{"left", {1, 0, 0}},    {"right", {0, 1, 0}},  {"front", {0, 0, 1}},
          {"back", {.5, .25, 0}}, {"bottom", {1, 1, 0}}, {"top", {.2, .4, .6}}};
}

void write_step_box(const std::filesystem::path& file, StepSchema schema, const std::string& unit) {
  StepDocument document;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  const TDF_Label product = document.add(box, "box");
  const std::vector<BoxFace> wanted = box_faces();
  const std::vector<TopoDS_Shape> faces = faces_of(box);
  for (std::size_t k = 0; k < wanted.size(); ++k)
    document.paint(document.add_part(product, faces.at(k), wanted[k].name.c_str()),
                   wanted[k].colour);
  document.write(file, schema, unit);
}

void write_plain_step(const std::filesystem::path& file, int coloured) {
  StepDocument document;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  const TDF_Label product = document.add(box, "block");
  for (int k = 0; k < coloured; ++k)
    document.paint(document.add_part(product, faces_of(box).at(static_cast<std::size_t>(k)), ""),
                   {1, 0, 0});
  document.write(file, StepSchema::ap214, "MM");
}

void write_step_bodies(const std::filesystem::path& file) {
  StepDocument document;
  const TopoDS_Shape left = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const TopoDS_Shape right = BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), 10, 10, 10).Shape();
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, left);
  builder.Add(both, right);
  const TDF_Label product = document.add(both, "bodies");
  document.paint(product, {0, 0, 1});
  document.paint(document.add_part(product, left, "left"), {1, 0, 0});
  document.add_part(product, right, "right");
  document.paint(document.add_part(product, faces_of(left).front(), ""), {1, 1, 0});
  document.write(file, StepSchema::ap214, "MM");
}

void write_step_assembly(const std::filesystem::path& file) {
  StepDocument document;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 4, 6).Shape();
  const TDF_Label peg = document.add(box, "peg");
  document.paint(peg, {0, 1, 0});
  document.paint(document.add_part(peg, faces_of(box).front(), ""), {1, 1, 1});
  const TDF_Label outer = document.shapes()->NewShape();
  TDataStd_Name::Set(outer, "outer");
  gp_Trsf turned;
  turned.SetRotation(gp::OZ(), M_PI / 2);
  document.shapes()->AddComponent(outer, peg, TopLoc_Location(moved(100, 0, 0) * turned));
  document.paint(document.shapes()->AddComponent(outer, peg, TopLoc_Location(moved(0, 50, 0))),
                 {1, 0, 0});
  document.shapes()->UpdateAssemblies();
  document.write(file, StepSchema::ap242, "MM");
}

void write_curved_step(const std::filesystem::path& file) {
  StepDocument document;
  document.paint(document.add(BRepPrimAPI_MakeSphere(10).Shape(), "ball"), {1, 0, 0});
  document.paint(
      document.add(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 20), gp::DZ()), 5, 20).Shape(),
                   "rod"),
      {0, 1, 0});
  document.write(file, StepSchema::ap214, "MM");
}

void write_many_faced_step(const std::filesystem::path& file, int holes) {
  StepDocument document;
  const int side = static_cast<int>(std::ceil(std::sqrt(holes)));
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(4. * side, 4. * side, 3).Shape();
  TopTools_ListOfShape plates, drills;
  plates.Append(plate);
  for (int k = 0; k < holes; ++k)
    drills.Append(BRepPrimAPI_MakeCylinder(
                      gp_Ax2(gp_Pnt(4. * (k % side) + 2, 4. * (k / side) + 2, 1), gp::DZ()), 1, 5)
                      .Shape());
  BRepAlgoAPI_Cut cut;
  cut.SetArguments(plates);
  cut.SetTools(drills);
  cut.Build();
  const TDF_Label product = document.add(cut.Shape(), "plate");
  int number = 0;
  for (const TopoDS_Shape& face : faces_of(cut.Shape())) {
    ++number;
    document.paint(document.add_part(product, face, ""),
                   {(number % 5) / 5., (number % 7) / 7., (number % 11) / 11.});
  }
  document.write(file, StepSchema::ap214, "MM");
}

}  // namespace aspect
