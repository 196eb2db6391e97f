// SPDX-License-Identifier: Apache-2.0
// Which directive does what; messages, #include, #version, #default.
#include "dioptre/core/expression_eval.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

constexpr std::uint64_t kMostSourceBytes = 256u << 20;
constexpr std::size_t kMostIncludes = 200;

}  // namespace

void Interpreter::run_directive(const Token& token) {
  const Nesting guard(*this);
  // What comes before a value under way must not be taken for its end.
  const auto keyword = static_cast<Keyword>(std::min(token.index, kKeywordCount));
  skip_raw();
  switch (keyword) {
    case Keyword::kDeclare:
      return run_declare(false);
    case Keyword::kLocal:
      return run_declare(true);
    case Keyword::kUndef:
      return run_undef();
    case Keyword::kIf:
      return run_if(token);
    case Keyword::kIfdef:
      return run_ifdef(token, true);
    case Keyword::kIfndef:
      return run_ifdef(token, false);
    case Keyword::kElse:
    case Keyword::kElseif:
    case Keyword::kCase:
    case Keyword::kRange:
      return run_else(token);
    case Keyword::kEnd:
      return run_end(token);
    case Keyword::kWhile:
      return run_while(token);
    case Keyword::kFor:
      return run_for(token);
    case Keyword::kSwitch:
      return run_switch(token);
    case Keyword::kBreak:
      return run_break(token);
    case Keyword::kMacro:
      return run_macro(token);
    case Keyword::kInclude:
      return run_include();
    case Keyword::kVersion:
      return run_version();
    case Keyword::kDefault:
      return run_default();
    case Keyword::kDebug:
    case Keyword::kRender:
    case Keyword::kStatistics:
    case Keyword::kWarning:
    case Keyword::kError:
      return run_message(keyword);
    case Keyword::kFopen:
      return run_fopen();
    case Keyword::kFclose:
      return run_fclose();
    case Keyword::kRead:
      return run_read();
    case Keyword::kWrite:
      return run_write();
    default:
      if (symbols_.name(token.index).empty()) return warn("a '#' without a directive: ignored");
      fail_at(token.position, "'#" + symbols_.name(token.index) + "' is no directive",
              meant(token.index, "did you mean '"));
  }
}

/// The text goes out as it is; the application prints it.
void Interpreter::run_message(Keyword keyword) {
  const SourcePosition where = (cursor_ - 1)->position;
  std::string text = parse_string();
  count_message(text.size());
  ++effects_;
  if (keyword == Keyword::kError) fail_at(where, std::move(text));
  if (keyword == Keyword::kWarning) {
    Diagnostic warning = diagnostic(Severity::kWarning, where, std::move(text));
    count_message(warning.source_line.size());
    return diagnostics_.report(std::move(warning));
  }
  Diagnostic note;
  note.severity = Severity::kNote;
  note.message = std::move(text);
  diagnostics_.report(std::move(note));
}

std::string Interpreter::read_file(const std::string& path) {
  constexpr std::uint64_t kShareOfMemory = 8;  // values take more room than their bytes
  Result<std::string> bytes = access_.read(path, budgets().memory_bytes / kShareOfMemory);
  if (!bytes) fail(bytes.error().message);
  charge(bytes->size());
  return *std::move(bytes);
}

std::shared_ptr<const Program> Interpreter::load_program(const std::string& name) {
  static constexpr std::string_view kEndings[] = {".inc"};
  const std::string path = find_file(name, kEndings);
  if (const auto known = cache_.find(path); known != cache_.end()) return known->second;
  Result<std::string> text = access_.read(path, kMostSourceBytes);
  if (!text) fail_at(file_name_at_, text.error().message);
  charge(text->size());
  const auto file = static_cast<std::uint32_t>(programs_.size());
  auto program =
      std::make_shared<Program>(lex(name, std::move(*text), file, symbols_, most_tokens()));
  programs_.push_back(program);
  source_map_.files.push_back(name);
  paths_.push_back(path);
  cache_[path] = program;
  return program;
}

std::string Interpreter::find_file(const std::string& name,
                                   std::span<const std::string_view> endings) {
  std::string wanted = name;
  for (char& c : wanted) {
    if (c == '\\') c = '/';
  }
  Result<FileAccess::Found> file = access_.find(wanted);
  for (std::size_t i = 0; !file && i < endings.size(); ++i) {
    if (auto longer = access_.find(wanted + std::string(endings[i]))) file = std::move(longer);
  }
  if (!file) fail_at(file_name_at_, file.error().message);
  if (wanted != name) {
    forgive(file_name_at_, "'\\' in the file name '" + name + "' is read as '/'",
            "write \"" + wanted + "\"");
  }
  if (file->other_case) {
    forgive(file_name_at_, "the file '" + name + "' was found in other upper or lower case",
            "it is " + file->path);
  }
  return file->path;
}

std::string Interpreter::find_font(const std::string& name) {
  static constexpr std::string_view kEndings[] = {".ttf"};
  std::string wanted = name;
  for (char& c : wanted) {
    if (c == '\\') c = '/';
  }
  const bool missing =
      access_.is_missing(wanted) && access_.is_missing(wanted + std::string(kEndings[0]));
  if (!missing || options_.strict) return find_file(name, kEndings);
  for (char& c : wanted) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const auto has = [&](std::string_view part) { return wanted.find(part) != wanted.npos; };
  const std::string own = has("cour") || has("mono") || has("consol")      ? "crystal.ttf"
                          : has("times") || has("roman") || has("georgia") ? "timrom.ttf"
                                                                           : "cyrvetic.ttf";
  forgive(file_name_at_, "cannot find the font '" + name + "': " + own + " stands for it",
          "put the font beside the scene");
  return find_file(own);
}

void Interpreter::run_include() {
  const SourcePosition where = (cursor_ - 1)->position;
  ready_ = false;
  enter_file(parse_file_name(), where);
}

void Interpreter::enter_file(const std::string& name, SourcePosition where) {
  std::size_t files = 0;
  for (const Frame& frame : frames_) files += !frame.macro;
  if (files >= kMostIncludes) {
    fail_at(where, "more than " + std::to_string(kMostIncludes) + " files include each other");
  }
  if (frames_.size() + nesting_ >= options_.budgets.nesting) over_nesting();
  const auto program = load_program(name);
  ++effects_;
  frames_.push_back({program_, cursor_, nullptr, where, blocks_.size(), {}});
  scopes_.enter();
  program_ = program.get();
  cursor_ = program_->tokens.data();
  ready_ = false;
}

void Interpreter::run_version() {
  const SourcePosition where = cursor_->position;
  const Token& token = raw();
  if (token.kind == Token::Kind::kName && symbols_.name(token.index) == "unofficial") skip_raw();
  const double wanted = parse_float();
  if (!(wanted >= 0 && wanted <= 3.85)) {
    fail_at(where,
            "this is POV-Ray 3.7's language, version " + formatted(wanted, 0, 1) + " is not known");
  }
  newer_language_ = wanted > 3.75;
  if (newer_language_) {
    forgive(where, "version 3.8 is read as 3.7", "write #version 3.7; if the scene needs no more");
  }
  // A semicolon may be taken only if it is here: what follows may depend on the new version.
  set_version(wanted);
  ++effects_;
  if (!pending_ && cursor_->is(';')) skip_raw();
}

void Interpreter::set_version(double version) {
  version_ = version > 3.75 ? 3.7 : version;
  scene_.settings.language_version = version_;
  version_given_ = true;
}

void Interpreter::run_default() {
  ++effects_;
  parse_default(*this);
}

}  // namespace dioptre::pov
