// SPDX-License-Identifier: Apache-2.0
#include "dioptre/scene/json.h"

#include "dioptre/scene/json_reader.h"
#include "dioptre/scene/json_writer.h"
#include "dioptre/scene/validate.h"

namespace dioptre {
namespace json {
namespace {

constexpr const char* kBytes = "bytes";

bool is_utf8(const std::string& text) {
  try {
    static_cast<void>(Json(text).dump());
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

/// One part of a JSON pointer (RFC 6901).
std::string escaped(const std::string& part) {
  std::string out;
  for (const char c : part) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out.push_back(c);
    }
  }
  return out;
}

}  // namespace

Json to_json(const std::string& v) {
  if (is_utf8(v)) return v;
  Json bytes = Json::array();
  for (const char c : v) bytes.push_back(static_cast<unsigned char>(c));
  Json out = Json::object();
  out[kBytes] = std::move(bytes);
  return out;
}

void Reader::fail(const std::string& what) {
  if (!good()) return;
  std::string pointer;
  for (const std::string& part : path_) pointer += "/" + escaped(part);
  problem_ = (pointer.empty() ? "/" : pointer) + ": " + what;
}

const std::string* Reader::type_of(const Json& json) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find("type");
  return found != json.end() && found->is_string() ? found->get_ptr<const std::string*>() : nullptr;
}

void Reader::read(const Json& json, bool& v) {
  if (!json.is_boolean()) return fail("expected true or false");
  v = json.get<bool>();
}

void Reader::read(const Json& json, double& v) {
  if (json.is_number()) {
    v = json.get<double>();
    return;
  }
  if (json == "inf") {
    v = std::numeric_limits<double>::infinity();
  } else if (json == "-inf") {
    v = -std::numeric_limits<double>::infinity();
  } else if (json == "nan") {
    v = std::numeric_limits<double>::quiet_NaN();
  } else {
    fail("expected a number");
  }
}

void Reader::read(const Json& json, float& v) {
  double wide = v;
  read(json, wide);
  constexpr double kTop = std::numeric_limits<float>::max();
  if (std::isfinite(wide) && std::fabs(wide) > kTop) return fail("the number is out of range");
  v = static_cast<float>(wide);
}

void Reader::read(const Json& json, std::string& v) {
  if (json.is_string()) {
    v = json.get<std::string>();
    return;
  }
  if (!json.is_object() || !json.contains(kBytes)) return fail("expected a string");
  std::vector<std::uint8_t> bytes;
  within(kBytes, [&] { read(json[kBytes], bytes); });
  v.assign(bytes.begin(), bytes.end());
}

namespace {

/// The place where brackets are nested deeper than any scene's, if there is one.
std::optional<std::size_t> too_deep(std::string_view text) {
  constexpr int kMaxDepth = 64;
  int depth = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_string) {
      if (c == '\\') ++at;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) return at;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return std::nullopt;
}

}  // namespace
}  // namespace json

std::string write_json(const Scene& scene) { return json::to_json(scene).dump(1) + "\n"; }

Result<Scene> read_json(std::string_view text) {
  if (const auto at = json::too_deep(text)) {
    return fail("byte " + std::to_string(*at) + ": brackets are nested too deeply");
  }
  json::Json parsed;
  try {
    parsed = json::Json::parse(text);
  } catch (const json::Json::parse_error& error) {
    return fail("byte " + std::to_string(error.byte) + ": this is not JSON");
  } catch (const json::Json::exception&) {
    return fail("a number is out of range");
  }
  json::Reader reader;
  Scene scene;
  reader.read(parsed, scene);
  if (!reader.good()) return fail(reader.problem());
  if (const auto valid = validate(scene); !valid) return tl::unexpected(valid.error());
  return scene;
}

}  // namespace dioptre
