#include <charconv>
#include <string>

#include "strata/openscad.h"

namespace strata {
namespace {

void append(std::string& text, double x) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, x == 0 ? 0.0 : x).ptr).push_back('\n');
}

}  // namespace

std::string to_dxf(const planar::Region& region) {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    text.append("0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n");
    for (const std::uint32_t v : region.loops.loop(l)) {
      const planar::PlanePoint& p = region.loops.places.place[v];
      text.append("0\nVERTEX\n8\n0\n10\n");
      append(text, p[0]);
      text.append("20\n");
      append(text, p[1]);
    }
    text.append("0\nSEQEND\n");
  }
  return text.append("0\nENDSEC\n0\nEOF\n");
}

}  // namespace strata
