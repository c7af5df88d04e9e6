#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "common/view.h"

/// Collects paths and writes them as SVG, fitted to a page.
class SvgPage {
 public:
  /// Lines of one look. Runs that share ends become one path, and points on a straight run are left out.
  void add_lines(std::vector<PaperPath> segments, double width, std::string_view colour);
  /// A filled polygon over everything before. Neighbours of one colour share a path.
  void add_polygon(const PaperPath& corners, std::string_view colour);

  /// The document, `width` units wide.
  [[nodiscard]] std::string text(double width, std::string_view title) const;
  [[nodiscard]] bool is_empty() const { return layers_.empty(); }

 private:
  struct Layer {
    std::vector<PaperPath> paths;
    double width = 0;    ///< of lines; 0: filled
    std::string colour;  ///< of lines or of the filling
  };
  std::vector<Layer> layers_;
};

/// Joins segments that share ends into runs, and leaves out points in the midst of straight ones, as far as doubles
/// tell.
[[nodiscard]] std::vector<PaperPath> join_runs(std::vector<PaperPath> segments);
