#include "extensions/planar/io/json_value.h"

namespace strata::planar {
namespace {

using Kind = JsonValue::Kind;

[[noreturn]] void fail(const JsonValue& at, const std::string& reason) { io::fail_at_line(at.offset, reason); }

const JsonValue& member(const JsonValue& v, const char* name, Kind kind) {
  const JsonValue* found = v.find(name);
  if (found == nullptr || found->kind != kind) fail(v, std::string("expected a member \"") + name + "\"");
  return *found;
}

const std::vector<JsonValue>& items(const JsonValue& v, const char* what) {
  if (v.kind != Kind::array) fail(v, std::string("expected ") + what);
  return v.items;
}

class GeoJsonReader {
 public:
  explicit GeoJsonReader(std::vector<std::string>& notes) : notes_(notes) {}

  Loops read(const JsonValue& v) {
    object(v);
    if (left_out_) notes_.emplace_back("more than two coordinates: the others were left out");
    return rings_.finish();
  }

 private:
  void object(const JsonValue& v) {
    if (v.kind != Kind::object) fail(v, "expected a GeoJSON object");
    const std::string& type = member(v, "type", Kind::text).text;
    if (type == "Polygon") return polygon(member(v, "coordinates", Kind::array));
    if (type == "MultiPolygon") return each(v, "coordinates", [&](const JsonValue& p) { polygon(p); });
    if (type == "GeometryCollection") return each(v, "geometries", [&](const JsonValue& g) { object(g); });
    if (type == "FeatureCollection") return each(v, "features", [&](const JsonValue& f) { object(f); });
    if (type != "Feature")
      fail(v, "expected Polygon, MultiPolygon, GeometryCollection, Feature or FeatureCollection, found " +
                  io::quoted(type));
    const JsonValue* geometry = v.find("geometry");
    if (geometry != nullptr && geometry->kind != Kind::null) object(*geometry);
  }
  template <class Visit>
  void each(const JsonValue& v, const char* name, const Visit& visit) {
    for (const JsonValue& item : member(v, name, Kind::array).items) visit(item);
  }
  void polygon(const JsonValue& rings) {
    bool is_shell = true;
    for (const JsonValue& ring : items(rings, "an array of rings")) {
      for (const JsonValue& p : items(ring, "an array of positions")) position(p);
      rings_.end_ring(is_shell);
      is_shell = false;
    }
  }
  void position(const JsonValue& p) {
    const std::vector<JsonValue>& numbers = items(p, "a position of two numbers");
    if (numbers.size() < 2) fail(p, "expected a position of two numbers");
    for (const JsonValue& x : numbers)
      if (x.kind != Kind::number) fail(x, "expected a number");
    left_out_ = left_out_ || numbers.size() > 2;
    rings_.add({io::ExactCoordinate{numbers[0].number, {}}, io::ExactCoordinate{numbers[1].number, {}}});
  }

  std::vector<std::string>& notes_;
  RingCollector rings_;
  bool left_out_ = false;
};

}  // namespace

Loops read_geojson(std::string_view text, std::vector<std::string>& notes) {
  return GeoJsonReader(notes).read(read_json(text));
}

}  // namespace strata::planar
