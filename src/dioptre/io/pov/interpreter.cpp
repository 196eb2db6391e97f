// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/interpreter.h"

#include <algorithm>

namespace dioptre::pov {
namespace {

constexpr std::uint64_t kStepsBetweenChecks = 1 << 14;

}  // namespace

Interpreter::Interpreter(const LoadOptions& options, const FileAccess& access,
                         SceneQueries& queries, Diagnostics& diagnostics)
    : options_(options),
      access_(access),
      queries_(queries),
      diagnostics_(diagnostics),
      begin_(std::chrono::steady_clock::now()) {
  for (const auto& [name, value] : options.declares) {
    Value& target = scopes_.global(symbols_.intern(name)).value;
    if (const double* v = std::get_if<double>(&value)) {
      target = number(*v);
    } else {
      target = std::make_shared<const std::string>(std::get<std::string>(value));
    }
  }
}

void Interpreter::run(const std::string& name, std::string text) {
  const auto file = static_cast<std::uint32_t>(programs_.size());
  programs_.push_back(std::make_shared<Program>(lex(name, std::move(text), file, symbols_)));
  source_map_.files.push_back(name);
  program_ = programs_.back().get();
  cursor_ = program_->tokens.data();
  while (peek().kind != Token::Kind::kEnd) parse_scene_item(*this);
  if (!blocks_.empty()) {
    fail("expected #end, found the end of the file",
         "each #if, #while, #for and #switch needs one");
  }
  settle_gamma();
}

/// Scenes of older versions, and those that name no version, are without gamma correction unless
/// they ask for it by assumed_gamma.
void Interpreter::settle_gamma() {
  if (!version_given_) {
    Diagnostic d;
    d.severity = Severity::kWarning;
    d.file = programs_.front()->name;
    d.message = "the scene names no #version: read as 3.7, but with the gamma rule of 3.6";
    diagnostics_.report(std::move(d));
  }
  scene_.settings.gamma_correction = gamma_given_ || (version_given_ && version_ >= 3.7 - 1e-9);
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
    if (c == '{' || c == '(') ++depth_;
    if (c == '}' || c == ')') --depth_;
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

void Interpreter::enter() {
  if (++nesting_ + frames_.size() > options_.budgets.nesting) {
    over_budget(std::to_string(options_.budgets.nesting) + " levels of nesting", "max-nesting");
  }
}

void Interpreter::check_budgets() {
  const LoadBudgets& budgets = options_.budgets;
  if (steps_ > budgets.steps) over_budget(std::to_string(budgets.steps) + " steps", "max-steps");
  if (scene_.objects.size() > budgets.objects) {
    over_budget(std::to_string(budgets.objects) + " objects", "max-objects");
  }
  if (budgets.seconds > 0) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    if (spent.count() > budgets.seconds) {
      over_budget("the time allowed for reading", "max-read-seconds");
    }
  }
  next_check_ = std::min(budgets.steps, steps_ + kStepsBetweenChecks) + (steps_ == budgets.steps);
}

}  // namespace dioptre::pov
