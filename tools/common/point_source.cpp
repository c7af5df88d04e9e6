#include "common/point_source.h"

#include "common/csv.h"
#include "strata/io.h"

namespace {

class CsvPoints : public PointSource {
 public:
  explicit CsvPoints(ByteSource& bytes) : table_(bytes, {"x", "y", "z"}) {}

  bool next(LineBlock& block) override { return table_.next(block); }
  void parse(const LineBlock& block, std::vector<double>& coordinates) const override {
    table_.parse(block, coordinates);
  }
  [[nodiscard]] std::optional<std::uint64_t> count() const override { return {}; }

 private:
  CsvReader table_;
};

}  // namespace

std::unique_ptr<PointSource> make_point_source(const std::string& path, ByteSource& bytes) {
  if (strata::format_of(path) == strata::Format::ply) return make_ply_points(bytes);
  return std::make_unique<CsvPoints>(bytes);
}
