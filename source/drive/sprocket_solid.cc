// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/sprocket_solid.h>
#include <chaindrive/files/file.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/config.h>

#include <string>

#ifdef DEAL_II_WITH_OPENCASCADE
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StlAPI_Writer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#endif

namespace chaindrive::drive
{
#ifdef DEAL_II_WITH_OPENCASCADE
namespace
{
constexpr double millimetres = 1e3;

TopoDS_Shape solid_of(const std::vector<Segment> &outline, const double bore, const double width)
{
  const double z  = -0.5 * millimetres * width;
  const auto   at = [z](const dealii::Point<2> &p) {
    return gp_Pnt(millimetres * p[0], millimetres * p[1], z);
  };
  const auto circle = [&at](const dealii::Point<2> &centre, const double radius) {
    return gp_Circ(gp_Ax2(at(centre), gp_Dir(0., 0., 1.)), millimetres * radius);
  };
  // pieces end where the next ones begin, in the same vertex
  std::vector<TopoDS_Vertex> corners;
  corners.reserve(outline.size());
  for (const Segment &s : outline)
    corners.push_back(BRepBuilderAPI_MakeVertex(at(s.begin)));
  BRepBuilderAPI_MakeWire profile;
  for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Segment       &s     = outline[i];
      const TopoDS_Vertex &begin = corners[i], &end = corners[(i + 1) % outline.size()];
      if (s.kind == Segment::Kind::line)
        profile.Add(BRepBuilderAPI_MakeEdge(begin, end));
      else if (s.end_angle > s.begin_angle)
        profile.Add(BRepBuilderAPI_MakeEdge(circle(s.centre, s.radius), begin, end));
      else
        profile.Add(TopoDS::Edge(
            BRepBuilderAPI_MakeEdge(circle(s.centre, s.radius), end, begin).Edge().Reversed()));
    }
  BRepBuilderAPI_MakeFace face(profile.Wire());
  const TopoDS_Wire       hole =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle(dealii::Point<2>(), 0.5 * bore)));
  face.Add(TopoDS::Wire(hole.Reversed()));
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0., 0., millimetres * width)).Shape();
}
} // namespace

void write_solid(const std::vector<Segment> &outline,
                 const double                bore,
                 const double                width,
                 const std::string          &path,
                 const std::string          &folder)
{
  // OpenCASCADE writes files and says little of what went wrong
  const std::string written = folder + "/solid";
  bool              done    = false;
  try
    {
      const TopoDS_Shape solid   = solid_of(outline, bore, width);
      const bool         is_step = path.size() > 4 && path.substr(path.size() - 5) == ".step";
      if (is_step)
        {
          Message::DefaultMessenger()->RemovePrinters(Message_Printer::get_type_descriptor());
          STEPControl_Writer writer;
          done = writer.Transfer(solid, STEPControl_AsIs) == IFSelect_RetDone &&
                 writer.Write(written.c_str()) == IFSelect_RetDone;
        }
      else
        {
          constexpr double         deflection = 0.01, angle = 0.2; // mm, rad
          BRepMesh_IncrementalMesh triangles(solid, deflection, false, angle);
          StlAPI_Writer            writer;
          done = writer.Write(solid, written.c_str());
        }
    }
  catch (const Standard_Failure &failure)
    {
      throw RunError("The solid of a sprocket cannot be built: " +
                     std::string(failure.GetMessageString()) + ".");
    }
  if (!done)
    throw RunError("The solid of a sprocket for '" + path + "' cannot be built.");
  files::write_text(path, files::read_text(written));
}
#else
void write_solid(
    const std::vector<Segment> &, double, double, const std::string &path, const std::string &)
{
  throw InputError("'" + path +
                   "' cannot be written: this deal.II was built without OpenCASCADE. Choose a name "
                   "that ends in .csv, .dxf or .svg.");
}
#endif
} // namespace chaindrive::drive
