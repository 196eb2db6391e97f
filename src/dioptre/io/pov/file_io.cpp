// SPDX-License-Identifier: Apache-2.0
// #fopen, #fclose, #read, #write.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

constexpr std::uint64_t kMostTextBytes = 1u << 30;
constexpr std::uint64_t kBytesPerFile = 1 << 16;  ///< that a file counts for, however short

struct BinaryType {
  double least = 0, most = 0;
  int bytes = 0;  ///< 0: text
  bool big_endian = false;
};

BinaryType binary_type(Keyword k) {
  switch (k) {
    case Keyword::kUint8:
      return {0, 255, 1, false};
    case Keyword::kSint8:
      return {-128, 127, 1, false};
    case Keyword::kUint16be:
      return {0, 65535, 2, true};
    case Keyword::kUint16le:
      return {0, 65535, 2, false};
    case Keyword::kSint16be:
      return {-32768, 32767, 2, true};
    case Keyword::kSint16le:
      return {-32768, 32767, 2, false};
    case Keyword::kSint32be:
      return {-2147483648.0, 2147483647.0, 4, true};
    case Keyword::kSint32le:
      return {-2147483648.0, 2147483647.0, 4, false};
    default:
      return {};
  }
}

std::string binary(const BinaryType& type, double value) {
  const double clipped = std::isnan(value) ? 0 : std::fmin(type.most, std::fmax(type.least, value));
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::round(clipped)));
  std::string bytes;
  for (int i = 0; i < type.bytes; ++i) {
    const int place = type.big_endian ? type.bytes - 1 - i : i;
    bytes += static_cast<char>(bits >> (8 * place) & 0xFF);
  }
  return bytes;
}

std::string written(const Numeric& n) {
  if (n.size == 1) return shortest(n.v[0]);
  std::string text = "<";
  for (std::uint8_t i = 0; i < n.size; ++i) (text += i ? "," : "") += shortest(n.v[i]);
  return text + "> ";
}

/// Reads the values of a #read file: numbers, vectors and strings with commas between them.
class ValueReader {
 public:
  explicit ValueReader(TextFile& file) : file_(file), text_(file.text) {}

  bool at_end() {
    skip_blanks();
    return file_.at >= text_.size();
  }
  /// False if there is no value here.
  bool read(Value& value) {
    skip_blanks();
    bool good = false;
    if (look() == '"') {
      good = read_string(value);
    } else if (look() == '<') {
      good = read_vector(value);
    } else {
      double v = 0;
      good = read_number(v);
      value = number(v);
    }
    skip_blanks();
    if (look() == ',') ++file_.at;
    return good;
  }

 private:
  char look() const { return file_.at < text_.size() ? text_[file_.at] : '\0'; }
  void skip_blanks() {
    while (file_.at < text_.size() && (look() <= ' ' && look() >= 0)) ++file_.at;
  }
  bool read_number(double& v) {
    const char* begin = text_.c_str() + file_.at;
    const char first = *begin == '-' || *begin == '+' ? begin[1] : *begin;
    if (!((first >= '0' && first <= '9') || first == '.')) return false;
    char* end = nullptr;
    v = std::strtod(begin, &end);
    file_.at += static_cast<std::size_t>(end - begin);
    return end != begin;
  }
  bool read_vector(Value& value) {
    Numeric n;
    n.size = 0;
    do {
      ++file_.at;
      skip_blanks();
      if (n.size == 5 || !read_number(n.v[n.size])) return false;
      ++n.size;
      skip_blanks();
    } while (look() == ',');
    if (look() != '>' || n.size < 2) return false;
    ++file_.at;
    value = n;
    return true;
  }
  bool read_string(Value& value) {
    std::string text;
    while (++file_.at < text_.size() && look() != '"') {
      if (look() == '\\' && file_.at + 1 < text_.size()) ++file_.at;
      text += look();
    }
    if (look() != '"') return false;
    ++file_.at;
    value = std::make_shared<const std::string>(std::move(text));
    return true;
  }

  TextFile& file_;
  const std::string& text_;
};

}  // namespace

void Interpreter::run_fopen() {
  const SourcePosition where = raw().position;
  const Symbol name = new_name("a name for the file");
  ready_ = false;
  const std::string path = parse_file_name();
  const Token mode = next();
  auto file = std::make_shared<TextFile>();
  ++effects_;
  if (mode.is(Keyword::kRead)) {
    file->path = find_file(path);
    Result<std::string> text = access_.read(file->path, kMostTextBytes);
    if (!text) fail_at(where, text.error().message);
    charge(text->size());
    file->text = std::move(*text);
  } else if (mode.is(Keyword::kWrite) || mode.is(Keyword::kAppend)) {
    std::string wanted = path;
    for (char& c : wanted) c = c == '\\' ? '/' : c;
    Result<std::string> allowed = access_.writable(wanted);
    if (!allowed) fail_at(where, allowed.error().message);
    count_written(kBytesPerFile);
    file->mode = TextFile::Mode::kWrite;
    file->path = *allowed;
    cache_.erase(*allowed);
    file->out.open(*allowed, mode.is(Keyword::kAppend) ? std::ios::binary | std::ios::app
                                                       : std::ios::binary | std::ios::trunc);
    if (!file->out) fail_at(where, "cannot open '" + path + "' for writing");
  } else {
    fail_at(mode.position, "expected read, write or append, found " + found(mode));
  }
  scopes_.global(name).value = std::move(file);
}

std::shared_ptr<TextFile> Interpreter::parse_handle() {
  const SourcePosition where = raw().position;
  const Symbol name = raw_identifier("the name of an open file");
  Binding* binding = scopes_.find(name);
  const auto* file = binding ? std::get_if<std::shared_ptr<TextFile>>(&binding->value) : nullptr;
  if (!file) {
    fail_at(where, "'" + symbols_.name(name) + "' is no open file", "open it with #fopen");
  }
  return *file;
}

void Interpreter::run_fclose() {
  ++effects_;
  const SourcePosition where = raw().position;
  const Symbol name = raw_identifier("the name of an open file");
  Binding* binding = scopes_.find(name);
  auto* file = binding ? std::get_if<std::shared_ptr<TextFile>>(&binding->value) : nullptr;
  if (!file) {
    warn("the file " + symbols_.name(name) + " is not open");
    return;
  }
  if ((*file)->mode == TextFile::Mode::kWrite) {
    (*file)->out.close();
    if (!(*file)->out) fail_at(where, "cannot write to '" + (*file)->path + "'");
  }
  binding->value = std::monostate();
}

void Interpreter::run_read() {
  ++effects_;
  if (!raw().is('(')) fail_at(raw().position, "expected '(' after #read, found " + found(raw()));
  open_raw();
  const Symbol handle = raw().index;
  const SourcePosition where = raw().position;
  const std::shared_ptr<TextFile> kept = parse_handle();
  TextFile& file = *kept;
  if (file.mode != TextFile::Mode::kRead) fail_at(where, "this file is open for writing");
  ValueReader reader(file);
  bool ended = false;
  while (!at(')')) {
    skip_comma();
    const Target target = parse_target(false);
    ready_ = false;
    if (ended || reader.at_end()) {
      ended = true;
      continue;
    }
    Value value;
    if (!reader.read(value)) {
      fail_at(target.position, "no number, vector or string at byte " + std::to_string(file.at) +
                                   " of the file that is read");
    }
    assign(target, std::move(value));
  }
  ended = ended || reader.at_end();
  expect(')', "after the names to read");
  if (!ended) return;
  if (Binding* binding = scopes_.find(handle)) binding->value = std::monostate();
}

void Interpreter::run_write() {
  expect('(', "after #write");
  const SourcePosition where = raw().position;
  const std::shared_ptr<TextFile> kept = parse_handle();
  TextFile& file = *kept;
  ready_ = false;
  if (file.mode != TextFile::Mode::kWrite) fail_at(where, "this file is open for reading");
  BinaryType type;
  while (!at(')')) {
    skip_comma();
    const Token token = peek();
    if (token.kind == Token::Kind::kName && token.index < kKeywordCount) {
      const BinaryType named = binary_type(static_cast<Keyword>(token.index));
      if (named.bytes > 0) {
        type = named;
        next();
        if (at(',') || at(')')) continue;
      }
    }
    std::string text;
    if (at_string()) {
      text = parse_string();
    } else {
      const Numeric n = at_color_keyword() ? color_terms() : sum();
      if (type.bytes == 0) text = written(n);
      for (std::uint8_t i = 0; type.bytes > 0 && i < n.size; ++i) text += binary(type, n.v[i]);
    }
    count_written(text.size());
    file.out << text;
  }
  expect(')', "after the values to write");
  if (!file.out) fail_at(where, "cannot write to '" + file.path + "'");
  ++effects_;
}

}  // namespace dioptre::pov
