// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/interpreter.h"

#include <algorithm>

#include "dioptre/io/pov/memory_use.h"

namespace dioptre::pov {

Interpreter::Interpreter(const LoadOptions& options, const FileAccess& access,
                         SceneQueries& queries, Diagnostics& diagnostics)
    : options_(options),
      access_(access),
      queries_(queries),
      diagnostics_(diagnostics),
      begin_(std::chrono::steady_clock::now()),
      first_bytes_(resident_bytes()) {
  scene_.settings.noise_generator = 0;  // until the scene names one or has come to its end
  if (options.version > 0) set_version(options.version);
  for (const auto& [name, value] : options.declares) {
    Value& target = scopes_.global(symbols_.intern(name)).value;
    if (const double* v = std::get_if<double>(&value)) {
      target = number(*v);
    } else {
      target = std::make_shared<const std::string>(std::get<std::string>(value));
    }
  }
}

void Interpreter::run(const std::string& name, std::string text, const std::string& path) {
  const auto file = static_cast<std::uint32_t>(programs_.size());
  programs_.push_back(
      std::make_shared<Program>(lex(name, std::move(text), file, symbols_, most_tokens())));
  source_map_.files.push_back(name);
  paths_.push_back(path);
  program_ = programs_.back().get();
  cursor_ = program_->tokens.data();
  if (!options_.include_header.empty()) enter_file(options_.include_header, cursor_->position);
  while (peek().kind != Token::Kind::kEnd) parse_scene_item(*this);
  if (!blocks_.empty()) {
    fail("expected #end, found the end of the file",
         "each #if, #while, #for and #switch needs one");
  }
  settle_version();
}

/// What the version reached at the end decides (measured). Scenes of older versions, and those that
/// name none, are without gamma correction unless they ask for it by assumed_gamma, and their
/// filters leave more of a surface's own light; before 3.5 noise was the first generator's.
void Interpreter::settle_version() {
  if (!version_given_) {
    Diagnostic d;
    d.severity = Severity::kWarning;
    d.file = programs_.front()->name;
    d.message = "the scene names no #version: read as 3.7, but with the look of 3.6";
    diagnostics_.report(std::move(d));
  }
  const bool modern = version() >= 3.7 - 1e-9;
  Settings& settings = scene_.settings;
  settings.language_version = version();
  settings.gamma_correction = gamma_given_ || modern;
  settings.old_opacity = !modern;
  if (settings.noise_generator == 0) settings.noise_generator = version() < 3.5 ? 1 : 2;
}

const Token& Interpreter::fetch() {
  for (;;) {
    const Token& token = *cursor_;
    current_ = &token;
    switch (token.kind) {
      case Token::Kind::kName:
        if (token.index >= kKeywordCount && !ends_value(token)) {
          const Binding* binding = scopes_.find(token.index);
          const auto* macro =
              binding ? std::get_if<std::shared_ptr<const Macro>>(&binding->value) : nullptr;
          if (macro) {
            expand_macro(*macro);
            continue;
          }
        }
        break;
      case Token::Kind::kDirective:
        if (ends_value(token)) break;
        run_directive(token);
        continue;
      case Token::Kind::kEnd:
        if (!ends_value(token) && end_program()) continue;
        break;
      case Token::Kind::kPunctuation:
        if (token.punctuation < ' ') fail_token(token);
        break;
      default:
        break;
    }
    current_ = cursor_;
    ready_ = true;
    return *cursor_;
  }
}

Token Interpreter::next() {
  const Token token = peek();
  count_step();
  if (pending_) {
    pending_ = ready_ = false;
    last_ = cursor_ - 1;
    ++taken_;
    return token;
  }
  if (token.kind == Token::Kind::kEnd || token.kind == Token::Kind::kDirective) return token;
  if (token.kind == Token::Kind::kPunctuation) {
    const char c = token.punctuation;
    if (c == '{' || c == '(') open_bracket(token);
    if (c == '}' || c == ')') close_bracket();
  }
  if (token.is(Keyword::kAssumedGamma)) gamma_given_ = true;
  last_ = cursor_++;
  ready_ = false;
  ++taken_;
  return token;
}

/// While a declaration's value is read: whether this directive, macro or end stands behind the
/// value and has to wait until the value is assigned.
bool Interpreter::ends_value(const Token& token) const {
  if (depth_ != value_depth_) return false;
  if (token.kind == Token::Kind::kEnd) return frames_.size() <= value_frames_;
  const bool complete = last_ && last_->is('}') && taken_ > value_begin_;
  if (token.kind == Token::Kind::kName) return complete;
  switch (static_cast<Keyword>(std::min(token.index, kKeywordCount))) {
    case Keyword::kIf:
    case Keyword::kIfdef:
    case Keyword::kIfndef:
    case Keyword::kSwitch:
      return false;
    case Keyword::kElse:
    case Keyword::kElseif:
    case Keyword::kCase:
    case Keyword::kRange:
    case Keyword::kBreak:
    case Keyword::kEnd:
      return blocks_.size() <= value_blocks_;
    case Keyword::kInclude:
      return taken_ > value_begin_;
    default:
      return frames_.size() <= value_frames_ && taken_ > value_begin_;
  }
}

void Interpreter::open_bracket(const Token& token) {
  ++depth_;
  open_.push_back({token.punctuation, token.position});
}

void Interpreter::close_bracket() {
  --depth_;
  if (!open_.empty()) open_.pop_back();
}

void Interpreter::open_raw() {
  open_bracket(raw());
  skip_raw();
}

void Interpreter::skip_raw() {
  ++cursor_;
  ready_ = false;
  count_step();
}

void Interpreter::move_to(const Token* token) {
  cursor_ = token;
  ready_ = false;
  count_step();
}

void Interpreter::leave_frame() {
  const Frame& frame = frames_.back();
  if (!frame.elements.empty()) give_back_elements(frame);
  program_ = frame.program;
  cursor_ = frame.cursor;
  ready_ = false;
  blocks_.resize(frame.blocks);
  frames_.pop_back();
  scopes_.leave();
}

/// At the end of a program: back to the includer. False if there is none.
bool Interpreter::end_program() {
  if (frames_.empty()) return false;
  if (blocks_.size() > frames_.back().blocks) {
    fail("expected #end, found the end of the file",
         "each #if, #while, #for and #switch needs one");
  }
  leave_frame();
  return true;
}

}  // namespace dioptre::pov
