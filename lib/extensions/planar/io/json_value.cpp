#include "extensions/planar/io/json_value.h"

namespace strata::planar {
namespace {

class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : scanner_(text) {}

  JsonValue read() {
    JsonValue v = value(0);
    scanner_.skip_space();
    if (!scanner_.at_end()) scanner_.fail_expected("the end of the file");
    return v;
  }

 private:
  JsonValue value(int depth) {
    constexpr int deepest = 512;
    if (depth > deepest) scanner_.fail("values are nested more than 512 deep");
    scanner_.skip_space();
    JsonValue v;
    v.offset = scanner_.offset();
    if (scanner_.accept('{')) {
      object(v, depth);
    } else if (scanner_.accept('[')) {
      array(v, depth);
    } else if (scanner_.peek() == '"') {
      v.kind = JsonValue::Kind::text;
      v.text = string();
    } else if (scanner_.is_at_number()) {
      v.kind = JsonValue::Kind::number;
      v.number = scanner_.number(false).nearest;
    } else {
      keyword(v);
    }
    return v;
  }
  void object(JsonValue& v, int depth) {
    v.kind = JsonValue::Kind::object;
    if (scanner_.accept('}')) return;
    do {
      scanner_.skip_space();
      v.names.push_back(string());
      scanner_.expect(':');
      v.items.push_back(value(depth + 1));
    } while (scanner_.accept(','));
    scanner_.expect('}');
  }
  void array(JsonValue& v, int depth) {
    v.kind = JsonValue::Kind::array;
    if (scanner_.accept(']')) return;
    do {
      v.items.push_back(value(depth + 1));
    } while (scanner_.accept(','));
    scanner_.expect(']');
  }
  std::string string() {
    scanner_.expect('"');
    std::string s;
    while (!scanner_.at_end() && scanner_.peek() != '"') {
      if (scanner_.peek() == '\\') s.push_back(scanner_.take());
      if (!scanner_.at_end()) s.push_back(scanner_.take());
    }
    if (scanner_.at_end()) scanner_.fail_expected("'\"'");
    scanner_.take();
    return s;
  }
  void keyword(JsonValue& v) {
    const std::string word = scanner_.word();
    if (word == "NULL") return;
    if (word != "TRUE" && word != "FALSE") scanner_.fail_expected("a JSON value");
    v.kind = JsonValue::Kind::truth;
  }

  Scanner scanner_;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return &items[i];
  return nullptr;
}

JsonValue read_json(std::string_view text) { return JsonReader(text).read(); }

}  // namespace strata::planar
