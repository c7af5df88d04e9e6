#include "call.h"

#include <cstdlib>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "strata/errors.h"
#include "strata/openscad.h"

__attribute__((import_module("strata"), import_name("progress"))) extern "C" void strata_web_progress(double fraction);

namespace strata::web {
namespace {

using Json = nlohmann::json;

Json defect_json(const Defect& defect) {
  Json json{{"kind", name(defect.kind)}, {"severity", name(defect.severity)}, {"faces", defect.faces},
            {"count", defect.count},     {"message", defect.message},         {"remedy", defect.remedy},
            {"where", Json(nullptr)}};
  if (defect.where) json["where"] = *defect.where;
  return json;
}

Json error_json(const char* kind, const std::exception& error) { return {{"kind", kind}, {"message", error.what()}}; }

/// Fields that an error of JavaScript has besides its message.
Json describe_current() {
  try {
    throw;
  } catch (const InputError& error) {
    Json json = error_json("input", error);
    json["operand"] = error.operand();
    json["defects"] = Json::array();
    for (const Defect& defect : error.defects()) json["defects"].push_back(defect_json(defect));
    return json;
  } catch (const IoError& error) {
    Json json = error_json("file", error);
    if (error.line()) json["line"] = *error.line();
    if (error.byte()) json["byte"] = *error.byte();
    return json;
  } catch (const CsgError& error) {
    Json json = error_json("model", error);
    json["line"] = error.line();
    json["column"] = error.column();
    return json;
  } catch (const ParseError& error) {
    Json json = error_json("expression", error);
    json["position"] = error.position();
    return json;
  } catch (const LogicError& error) {
    return error_json("fault", error);
  } catch (const std::bad_alloc&) {
    return {{"kind", "memory"}, {"message", "out of memory"}};
  } catch (const std::exception& error) {
    return error_json("argument", error);
  }
}

std::string text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

Answer& answer() {
  static Answer answer;
  return answer;
}

unsigned guarded(FunctionRef<unsigned()> work) {
  answer() = Answer();
  try {
    return work();
  } catch (const std::exception&) {
    answer().error = text(describe_current());
    return 0;
  }
}

Options watched() {
  Options options;
  options.progress = [](double fraction) { strata_web_progress(fraction); };
  return options;
}

std::string defects_text(std::span<const Defect> defects) {
  Json json = Json::array();
  for (const Defect& defect : defects) json.push_back(defect_json(defect));
  return text(json);
}

}  // namespace strata::web

using strata::web::answer;

STRATA_WEB(allocate) void* strata_allocate(std::size_t bytes) { return std::malloc(bytes); }
STRATA_WEB(release) void strata_release(void* memory) { std::free(memory); }
STRATA_WEB(bytes) const char* strata_bytes() { return answer().bytes.data(); }
STRATA_WEB(bytes_size) std::size_t strata_bytes_size() { return answer().bytes.size(); }
STRATA_WEB(reals) const double* strata_reals() { return answer().reals.data(); }
STRATA_WEB(reals_size) std::size_t strata_reals_size() { return answer().reals.size(); }
STRATA_WEB(ints) const unsigned* strata_ints() { return answer().ints.data(); }
STRATA_WEB(ints_size) std::size_t strata_ints_size() { return answer().ints.size(); }
STRATA_WEB(error) const char* strata_error() { return answer().error.data(); }
STRATA_WEB(error_size) std::size_t strata_error_size() { return answer().error.size(); }
