#include "chain_checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "common/json_location.h"
#include "common/output_file.h"
#include "common/sha256.h"
#include "common/text_file.h"
#include "strata/io.h"
#include "threads.h"

namespace {

using strata::Format;

constexpr std::string_view title = "# strata chain checkpoint ";
constexpr unsigned version = 1;

struct Header {
  std::size_t done = 0;
  std::string digest;
  std::vector<ChainMark> marks;
  strata::Unit unit = strata::Unit::none;
};

[[noreturn]] void fail(const std::string& path, const std::string& reason) { throw strata::IoError(path, {}, reason); }

std::size_t read_count(const JsonLocation& place) {
  if (!place.value().is_number_unsigned()) place.fail_expected("a count");
  return place.value().get<std::size_t>();
}

Header read_header(std::string_view text, const std::string& path) {
  const Json json = parse_json(text, path);
  const JsonLocation root(json, path);
  if (read_count(root.at("version")) != version) root.at("version").fail_expected(fmt::format("{}", version));
  Header header{read_count(root.at("done")), root.at("digest").text(), read_marks(root)};
  if (const auto place = root.find("unit")) {
    const auto unit = strata::unit_named(place->text());
    if (!unit) place->fail_expected("the name of a unit");
    header.unit = *unit;
  }
  if (header.marks.size() != header.done + 1) root.fail("the number of marks is not that of the steps done and one");
  return header;
}

void require_same(const Header& header, const std::vector<ChainMark>& marks, const std::string& path) {
  if (const std::string found = difference(marks, header.marks); !found.empty())
    fail(path, "belongs to other steps: " + found);
  if (header.marks.size() > marks.size())
    fail(path, fmt::format("belongs to other steps: {} are done, of which the document has {} only", header.done,
                           marks.size() - 1));
}

}  // namespace

void write_checkpoint(const std::string& path, const ChainCheckpoint& checkpoint, const std::vector<ChainMark>& marks,
                      const Settings& settings) {
  const std::string body =
      on_threads(settings, [&] { return strata::to_string(checkpoint.solid.exact_mesh(), Format::xoff); });
  Json header = {{"version", version}, {"done", checkpoint.done}, {"digest", sha256(body)}};
  if (checkpoint.unit != strata::Unit::none) header["unit"] = strata::name(checkpoint.unit);
  header.update(to_json(marks, checkpoint.done + 1));
  OutputFile file(path);
  file.write(fmt::format("{}{}\n", title, header.dump()));
  file.write(body);
  file.finish();
}

ChainCheckpoint read_checkpoint(const std::string& path, const std::vector<ChainMark>& marks,
                                const Settings& settings) {
  const std::string bytes = read_file(path);
  const std::string_view text = bytes;
  const std::size_t end = text.find('\n');
  if (!text.starts_with(title) || end == text.npos) fail(path, "is no checkpoint of a chain");
  const Header header = read_header(text.substr(title.size(), end - title.size()), path);
  require_same(header, marks, path);
  if (sha256(text.substr(end + 1)) != header.digest) fail(path, "was changed since it was written");
  return on_threads(settings, [&] {
    strata::MeshFile file = strata::read_mesh(text, Format::xoff, path);
    return ChainCheckpoint{
        header.done,
        strata::Solid(strata::ExactMesh{std::move(file.mesh), std::move(file.exact)}, strata::InputClass::solid),
        header.unit};
  });
}

void require_writable(const std::string& path) { const OutputFile probe(path); }
