#include "extensions/openscad/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/io/face_list.h"
#include "extensions/openscad/arguments.h"
#include "strata/check.h"

namespace strata::openscad {
namespace {

const std::vector<Value>& items_of(const Arguments& arguments, const char* parameter) {
  static const std::vector<Value> none;
  const Value* const value = arguments.find(parameter);
  if (value == nullptr) return none;
  if (value->kind != Value::Kind::vector) arguments.fail(parameter, "are no vector");
  return value->items;
}

std::vector<Vertex> points_of(const Arguments& arguments) {
  std::vector<Vertex> points;
  for (const auto& p : arguments.points("points", 3)) points.push_back({p[0], p[1], p[2]});
  return points;
}

std::uint32_t corner_of(const Value& value, std::size_t points, std::size_t face, const Arguments& arguments) {
  const bool is_index = value.kind == Value::Kind::number && value.number >= 0 &&
                        value.number < static_cast<double>(points) && value.number == std::floor(value.number);
  if (!is_index)
    arguments.fail("faces", "have a corner at number " + std::to_string(face) +
                                " that is no number of a point: there are " + std::to_string(points));
  return static_cast<std::uint32_t>(value.number);
}

io::FaceList faces_of(const Arguments& arguments, std::size_t points) {
  io::FaceList faces;
  std::vector<std::uint32_t> corners;
  for (std::size_t face = 0; const Value& item : items_of(arguments, "faces")) {
    if (item.kind != Value::Kind::vector) arguments.fail("faces", "have no vector at number " + std::to_string(face));
    corners.clear();
    for (const Value& v : item.items) corners.push_back(corner_of(v, points, face, arguments));
    std::reverse(corners.begin(), corners.end());  // counter-clockwise here
    if (corners.empty()) corners.push_back(0);     // is left out and noted
    faces.add(corners);
    ++face;
  }
  return faces;
}

/// "self-intersection at 0 0 1, faces 2 and 5"
std::string summary(const Defect& defect, const MeshFile& file) {
  std::string text(name(defect.kind));
  if (defect.where) {
    text += " at";
    for (const double x : *defect.where) text.append(" ").append(std::to_string(x));
  }
  if (!defect.faces.empty()) text += defect.faces.size() == 1 ? ", face" : ", faces";
  for (std::size_t i = 0; i < defect.faces.size(); ++i) {
    const std::uint32_t f = defect.faces[i];
    const std::uint32_t face = f < file.polygon_of_triangle.size() ? file.polygon_of_triangle[f] : f;
    text.append(i == 0 ? " " : " and ").append(std::to_string(face));
  }
  return text;
}

void require_solid(const MeshFile& file, const SyntaxNode& node, const Report& report) {
  for (const Defect& d : check(file.mesh)) {
    if (d.severity != Severity::error) continue;
    const char* const advice =
        d.kind == DefectKind::inside_out ? "; faces are listed clockwise as seen from outside" : "";
    report.fail(node.place, "the polyhedron bounds no solid: " + summary(d, file) + advice);
  }
}

}  // namespace

std::optional<Solid> polyhedron(const SyntaxNode& node, Report& report) {
  const Arguments arguments(node, {"points", "faces", "convexity"}, report);
  MeshFile file;
  file.mesh.vertices = points_of(arguments);
  const io::FaceList faces = faces_of(arguments, file.mesh.vertices.size());
  io::gather_faces({&faces, 1}, file, "polyhedron");
  if (file.mesh.triangles.empty()) {
    report.note(node.place, "a polyhedron without faces makes nothing");
    return std::nullopt;
  }
  for (const std::string& note : file.notes) report.note(node.place, "polyhedron: " + note);
  require_solid(file, node, report);
  return Solid(std::move(file.mesh));
}

}  // namespace strata::openscad
