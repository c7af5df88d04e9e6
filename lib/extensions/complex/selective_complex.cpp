#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "extensions/complex/simplify.h"
#include "strata/complex.h"

namespace strata::complex {

namespace {

/// Incidences, computed when they are first needed. Sets over the same cells share them.
class LazyIncidences {
 public:
  const Incidences& of(const Cells& cells) {
    std::call_once(once_, [&] { incidences_ = Incidences(cells); });
    return incidences_;
  }

 private:
  std::once_flag once_;
  Incidences incidences_;
};

}  // namespace

struct SelectiveComplex::Data {
  explicit Data(Cells c, std::shared_ptr<LazyIncidences> known = std::make_shared<LazyIncidences>())
      : cells(std::move(c)), incidences(std::move(known)) {}
  Cells cells;
  std::shared_ptr<LazyIncidences> incidences;
};

namespace {

Cells one_cell(int dimension, bool mark) {
  if (dimension != 2 && dimension != 3) throw std::invalid_argument("complexes have dimension 2 or 3");
  Cells cells;
  cells.dimension = dimension;
  cells.marks[static_cast<std::size_t>(dimension)] = {mark ? std::uint8_t{1} : std::uint8_t{0}};
  if (dimension == 2) cells.plane = {0};
  return cells;
}

}  // namespace

SelectiveComplex::SelectiveComplex(int dimension) : data_(Shared<Data>::make(one_cell(dimension, false))) {}

SelectiveComplex SelectiveComplex::all(int dimension) {
  return SelectiveComplex(Shared<Data>::make(one_cell(dimension, true)));
}

SelectiveComplex SelectiveComplex::of(const Cells& cells) {
  return SelectiveComplex(Shared<Data>::make(simplified(cells)));
}

const Cells& SelectiveComplex::cells() const { return data_->cells; }
const Incidences& SelectiveComplex::incidences() const { return data_->incidences->of(data_->cells); }

std::vector<std::uint8_t> SelectiveComplex::marks() const {
  std::vector<std::uint8_t> all;
  for (const auto& list : cells().marks) all.insert(all.end(), list.begin(), list.end());
  return all;
}

SelectiveComplex SelectiveComplex::with_marks(std::span<const std::uint8_t> marks) const {
  if (marks.size() != incidences().count()) throw std::invalid_argument("one mark per cell is needed");
  Cells changed = cells();
  auto next = marks.begin();
  for (auto& list : changed.marks) {
    std::copy_n(next, list.size(), list.begin());
    next += static_cast<std::ptrdiff_t>(list.size());
  }
  if (auto fewer = simplified_if_needed(changed)) return SelectiveComplex(Shared<Data>::make(*std::move(fewer)));
  return SelectiveComplex(Shared<Data>::make(std::move(changed), data_->incidences));
}

SelectiveComplex SelectiveComplex::with_marks(FunctionRef<bool(Cell)> mark) const {
  std::vector<std::uint8_t> marks(incidences().count());
  for (std::uint32_t c = 0; c < marks.size(); ++c) marks[c] = mark(incidences().cell(c)) ? 1 : 0;
  return with_marks(marks);
}

bool SelectiveComplex::is_empty() const { return incidences().count() == 1 && !mark({dimension(), 0}); }
bool SelectiveComplex::is_all() const { return incidences().count() == 1 && mark({dimension(), 0}); }

bool operator==(const SelectiveComplex& a, const SelectiveComplex& b) {
  return a.data_ == b.data_ || a.cells() == b.cells();
}

}  // namespace strata::complex
