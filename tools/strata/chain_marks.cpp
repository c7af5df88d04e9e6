#include "chain_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "common/sha256.h"
#include "strata/errors.h"

namespace {

constexpr const char* start_operation = "start";

std::string text_of(const ChainOperand& operand) {
  if (operand.transform.is_identity()) return {};
  std::string text;
  for (const strata::Transform::Row& row : operand.transform.rows())
    for (const strata::Rational& x : row) text += (text.empty() ? "" : " ") + x.str();
  return operand.placement == strata::Placement::rounded ? text + " rounded" : text;
}

class Marker {
 public:
  explicit Marker(const std::string& document) : document_(document) {}

  ChainMark mark(const std::string& operation, const ChainOperand& operand) {
    return {operation, digest(operand), name(operand.input), text_of(operand)};
  }

 private:
  const std::string& digest(const ChainOperand& operand) {
    if (operand.path == "-")
      throw UsageError(fmt::format("{}: {}.file: checkpoints need files, standard input cannot be looked at again",
                                   document_, operand.place));
    const auto [found, is_new] = digests_.try_emplace(operand.path);
    if (!is_new) return found->second;
    try {
      return found->second = sha256_of_file(operand.path);
    } catch (const strata::IoError& error) {
      throw strata::IoError(document_, {}, fmt::format("{}.file: {}", operand.place, error.what()));
    }
  }

  const std::string& document_;
  std::map<std::string, std::string> digests_;  // by path
};

ChainMark read_mark(const JsonLocation& place, const std::vector<std::string>& files) {
  const std::vector<JsonLocation> items = place.items();
  if (items.size() != 4) place.fail_expected("four values");
  ChainMark mark;
  const std::array<std::pair<std::size_t, std::string*>, 3> texts = {
      {{0, &mark.operation}, {2, &mark.input}, {3, &mark.transform}}};
  for (const auto& [k, text] : texts) {
    if (!items[k].value().is_string()) items[k].fail_expected("a string");
    *text = items[k].value().get<std::string>();
  }
  if (const auto operation = strata::operation_named(mark.operation)) mark.operation = name(*operation);
  if (items[1].value().is_null()) return mark;
  if (!items[1].value().is_number_unsigned() || items[1].value().get<std::size_t>() >= files.size())
    items[1].fail_expected("the number of a file");
  mark.file = files[items[1].value().get<std::size_t>()];
  return mark;
}

std::string place_of(std::size_t k) { return k == 0 ? "start" : fmt::format("steps[{}]", k - 1); }

std::string difference(const ChainMark& now, const ChainMark& before, const std::string& place) {
  if (now.operation != before.operation)
    return fmt::format("{}.operation is {}, was {}", place, now.operation, before.operation);
  if (now.file.empty() != before.file.empty())
    return fmt::format("{} {}, {}", place, now.file.empty() ? "is null" : "is a file",
                       now.file.empty() ? "was a file" : "was null");
  if (now.file != before.file) return fmt::format("{}.file has other content than then", place);
  if (now.input != before.input) return fmt::format("{}.input is {}, was {}", place, now.input, before.input);
  if (now.transform == before.transform) return {};
  const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
  return fmt::format("{}.transform is {}, was {}", place, shown(now.transform), shown(before.transform));
}

}  // namespace

std::vector<ChainMark> marks_of(const ChainDocument& document) {
  Marker marker(document.name);
  std::vector<ChainMark> marks;
  marks.push_back(document.start ? marker.mark(start_operation, *document.start)
                                 : ChainMark{start_operation, {}, {}, {}});
  for (const ChainStep& step : document.steps) marks.push_back(marker.mark(name(step.operation), step.operand));
  return marks;
}

Json to_json(const std::vector<ChainMark>& marks, std::size_t count) {
  std::map<std::string, std::size_t> numbers;
  Json files = Json::array(), list = Json::array();
  for (std::size_t k = 0; k < count; ++k) {
    const ChainMark& m = marks[k];
    Json file = nullptr;
    if (!m.file.empty()) {
      const auto [number, is_new] = numbers.try_emplace(m.file, files.size());
      if (is_new) files.push_back(m.file);
      file = number->second;
    }
    list.push_back(Json::array({m.operation, std::move(file), m.input, m.transform}));
  }
  return {{"files", std::move(files)}, {"marks", std::move(list)}};
}

std::vector<ChainMark> read_marks(const JsonLocation& place) {
  std::vector<std::string> files;
  for (const JsonLocation& file : place.at("files").items()) files.push_back(file.text());
  std::vector<ChainMark> marks;
  for (const JsonLocation& mark : place.at("marks").items()) marks.push_back(read_mark(mark, files));
  return marks;
}

std::string difference(const std::vector<ChainMark>& now, const std::vector<ChainMark>& before) {
  for (std::size_t k = 0; k < std::min(now.size(), before.size()); ++k)
    if (std::string found = difference(now[k], before[k], place_of(k)); !found.empty()) return found;
  return {};
}
