// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "dioptre/core/diagnostics.h"
#include "dioptre/core/expression.h"
#include "dioptre/io/file_access.h"
#include "dioptre/io/load_scene.h"
#include "dioptre/io/pov/parser.h"
#include "dioptre/io/pov/scopes.h"
#include "dioptre/io/pov/text_file.h"
#include "dioptre/io/pov/value.h"

namespace dioptre::pov {

/// What ends the reading: an error that is to be reported. Never leaves load_scene.cpp.
struct Failure {
  Diagnostic diagnostic;
};

/// The place of the component that a token after '.' names; 5: grey; -1: none.
int component_place(const Token& token);

/// `rgb`, `red`, `color` and the like.
bool is_color_keyword(Keyword k);
/// The language of scenes that name no version, in all that a version decides, though `version`
/// reads 3.7 in them (measured).
inline constexpr double kUnnamedVersion = 3.6;
/// As C's %g: six digits at most.
std::string shortest(double value);
/// Days since the beginning of the year 2000, Greenwich.
double days_now();

/// Runs a program of the scene language: hands out its tokens with the directives carried out,
/// evaluates expressions, and keeps the scene that the grammar builds.
class Interpreter final : public Parser {
 public:
  Interpreter(const LoadOptions& options, const FileAccess& access, SceneQueries& queries,
              Diagnostics& diagnostics);

  /// Runs a program to its end. Throws Failure.
  /// `path` is that of its file, if it is one.
  void run(const std::string& name, std::string text, const std::string& path);
  /// The error of having no memory left, at the place reached.
  Diagnostic out_of_memory() const;
  LoadedScene take_result() {
    return {std::move(scene_), std::move(source_map_), std::move(paths_)};
  }

  // Parser
  const Token& peek() override { return ready_ ? *current_ : fetch(); }
  Token next() override;
  void expect(char c, std::string_view why = {}) override;
  bool at_expression() override;
  Numeric parse_numeric() override;
  double parse_float() override;
  bool parse_bool() override;
  bool parse_flag() override;
  Vec2 parse_vec2() override;
  Vec3 parse_vec3() override;
  PigmentColor parse_color() override;
  bool at_color() override;
  std::string parse_string() override;
  bool at_string() override;
  std::string parse_file_name() override;
  DescribedPtr take_described() override;
  const Described* peek_described() override;
  const std::string& last_name() const override { return last_name_; }
  FunctionId parse_function() override;
  Scene& scene() override { return scene_; }
  SourceMap& source_map() override { return source_map_; }
  SceneQueries& queries() override;
  double version() const override { return version_given_ ? version_ : kUnnamedVersion; }
  SourcePosition position() override { return peek().position; }
  void charge(std::uint64_t bytes) override;
  void check_levels() override;
  const LoadBudgets& budgets() const override { return options_.budgets; }
  std::string find_file(const std::string& name,
                        std::span<const std::string_view> endings = {}) override;
  std::string find_font(const std::string& name) override;
  std::string read_file(const std::string& path) override;
  ReadImages& read_images() override { return read_images_; }
  [[noreturn]] void fail(std::string message, std::string how_to_mend = {}) override;
  [[noreturn]] void fail_at(SourcePosition where, std::string message,
                            std::string how_to_mend = {}) override;
  [[noreturn]] void fail_expected(std::string_view what) override;
  void warn(std::string message, std::string how_to_mend = {}) override;
  void warn_at(SourcePosition where, std::string message, std::string how_to_mend = {}) override;
  void forgive(SourcePosition where, std::string message, std::string how_to_mend = {}) override;
  double parse_setting_float() override;
  bool accept_word(std::string_view word) override;
  void not_rendered(std::string_view feature) override;

 protected:
  void enter() override;
  void leave() override { --nesting_; }

 private:
  // --- running tokens (interpreter.cpp) ---------------------------------------------------------
  struct Subscripts {
    std::array<double, 16> at;
    std::size_t count = 0;
  };
  /// An element of an array that is a macro's argument.
  struct ElementReference {
    Symbol parameter = 0;
    Binding* array = nullptr;
    Subscripts subscripts;
  };
  /// A place to come back to: the caller of a macro or the includer of a file.
  struct Frame {
    const Program* program = nullptr;
    const Token* cursor = nullptr;
    std::shared_ptr<const Macro> macro;  ///< the one that runs in this frame, if any
    SourcePosition called;               ///< where this frame was entered
    std::size_t blocks = 0;              ///< how many blocks were open then
    std::vector<ElementReference> elements;
  };
  /// A directive whose #end has not come yet.
  struct Block {
    enum class Kind : std::uint8_t { kIf, kWhile, kFor, kSwitch, kMacro } kind = Kind::kIf;
    const Token* begin = nullptr;  ///< #while: its condition; #for: its body
    const Token* end = nullptr;    ///< the #end
    Symbol variable = 0;           ///< #for
    double last = 0, step = 0;     ///< #for
    double value = 0;              ///< #switch
    std::uint64_t effects = 0;     ///< what effects_ was when this round began
    std::uint32_t scope = 0;       ///< #for: where the variable lives
  };
  const Token& fetch();
  const Token& raw() const { return *cursor_; }
  void skip_raw();
  void open_bracket(const Token& token);
  void close_bracket();
  void open_raw();  ///< takes a '(' as it stands
  void move_to(const Token* token);
  void expand_macro(std::shared_ptr<const Macro> called);
  void leave_frame();
  void give_back_elements(const Frame& frame);
  bool end_program();
  bool ends_value(const Token& token) const;
  void settle_version();
  void count_step() {
    if (++steps_ >= next_check_) check_budgets();
  }
  void check_budgets();
  void check_memory();
  void check_elements(std::uint64_t count);
  void count_written(std::uint64_t bytes);
  void count_message(std::size_t size);
  std::uint64_t most_tokens() const { return options_.budgets.memory_bytes / sizeof(Token) / 2; }
  [[noreturn]] void over_nesting();
  bool is_new(const std::string& message, std::uint32_t file, std::uint32_t line);
  void warn_once(SourcePosition where, const std::string& message);  ///< per file, not per line
  [[noreturn]] void fail_token(const Token& token);
  [[noreturn]] void over_budget(std::string what, std::string_view option);
  std::string found(const Token& token) const;
  std::string unknown_name(Symbol name) const;
  std::string meant(Symbol name, std::string_view question) const;
  std::string open_brackets() const;
  [[noreturn]] void fail_undeclared(SourcePosition where, Symbol name);
  Diagnostic diagnostic(Severity severity, SourcePosition where, std::string message) const;

  // --- directives (directives.cpp, control.cpp, declarations.cpp, macros.cpp, file_io.cpp) ------
  void run_directive(const Token& token);
  void run_message(Keyword keyword);
  void run_include();
  void enter_file(const std::string& name, SourcePosition where);
  void run_version();
  void set_version(double version);
  void run_default();
  std::shared_ptr<const Program> load_program(const std::string& name);

  void begin_if(const Token& token, bool condition);
  void run_if(const Token& token);
  void run_ifdef(const Token& token, bool wanted);
  void run_else(const Token& token);
  void run_end(const Token& token);
  void run_while(const Token& token);
  bool next_round(Block& block);
  void run_for(const Token& token);
  void next_for(Block& block);
  void skip_empty_for(Block& block, Binding& variable);
  void run_switch(const Token& token);
  bool case_holds(const Token& token);
  void seek_case(const Token* branch);
  void run_break(const Token& token);
  bool parse_condition();
  const Token* branch_of(const Token& token);
  const Token* end_of(const Token& token);
  Block& innermost(const Token& token, std::string_view directive);

  void run_declare(bool local);
  void run_undef();
  bool parse_defined();
  /// What a declaration sets.
  struct Target {
    Symbol name = 0;
    bool local = false;
    std::uint32_t scope = 0;
    SourcePosition position;
    Subscripts subscripts;
    bool deprecated = false, deprecated_once = false;
    std::string deprecation;
  };
  Target parse_target(bool local);
  Target parse_deprecated_target(bool local);
  void parse_subscripts(Subscripts& subscripts);
  void deepen(Array& array, const Value& element, std::uint32_t levels);
  Value* locate(Value& root, const Subscripts& subscripts, SourcePosition where, bool for_change);
  void assign(const Target& target, Value value);
  Value parse_value(Symbol name);
  Value parse_array();
  void fill_array(Array& array, std::size_t dimension, std::size_t& place);
  std::shared_ptr<Array> counted_array();
  void end_declaration(const Value& value, const Target& target);
  void warn_deprecated(Binding& binding);

  void run_macro(const Token& token);
  std::string_view type_name(const Value& value) const;

  void run_fopen();
  void run_fclose();
  void run_read();
  void run_write();
  std::shared_ptr<TextFile> parse_handle();
  Symbol raw_identifier(std::string_view what);
  Symbol new_name(std::string_view what);

  // --- expressions (expressions.cpp, numeric_functions.cpp, strings.cpp, colors.cpp) ------------
  const Value* operand();
  Numeric sum();
  Numeric product();
  Numeric factor();
  Numeric primary();
  Numeric name_value();
  Numeric component(Numeric n);
  Numeric logical();
  Numeric relation();
  Numeric full();  ///< with relations, logic and ?: as within parentheses
  Numeric vector_literal();
  Numeric parenthesised();
  Numeric combine(char op, const Numeric& a, const Numeric& b);
  double float_argument();
  Vec3 vector_argument();
  double as_float(const Numeric& n, SourcePosition where);
  bool keyword_begins_expression(Keyword k) const;
  bool value_is_numeric(const Value& value) const;
  Numeric keyword_value(Keyword k);
  /// A variable of the clock or the picture. They are as the scene's own: it may declare them anew
  /// (measured; not clock itself).
  std::optional<double> built_in_variable(Keyword k) const;
  Numeric function_value(Keyword k);
  Numeric rotated_about_axis();
  double math(Keyword k, Step::Code code);
  double extremum(Keyword k);
  double bitwise(Keyword k);
  double random();
  double seed();
  Numeric select();
  double dimension(bool size);
  double strings_compared();
  Numeric trace();
  Numeric extent(bool upper);
  double inside();
  Numeric turbulence_vector();
  ObjectId object_argument();
  ObjectId registered(const DescribedPtr& described, const Object& object);
  bool string_relation(double& result);

  bool at_color_keyword();
  Numeric color_factor();
  Numeric color_terms();
  Numeric to_color(const Numeric& n);
  void color_component(Numeric& color);
  std::string string_function(Keyword k);
  std::string concatenation();
  std::string formatted(double value, double length, double precision);
  std::string vector_string();
  std::string substring();
  std::string date_and_time();
  std::string character();
  std::string string_argument();
  void check_string(std::size_t size);

  // --- functions (functions.cpp, function_body.cpp, function_values.cpp) ------------------------
  friend class FunctionCompiler;
  std::shared_ptr<const FunctionValue> parse_function_value(const std::string& name);
  std::shared_ptr<const FunctionValue> parse_function_body(const std::string& name,
                                                           std::vector<std::string> parameters);
  std::vector<std::string> parse_parameters();
  FunctionId add_function(const std::string& name, const std::vector<std::string>& parameters,
                          Function::Body body);
  std::shared_ptr<const FunctionValue> color_function(const std::string& name);
  std::shared_ptr<const FunctionValue> spline_function(const std::string& name);
  std::shared_ptr<const FunctionValue> transform_function(const std::string& name);
  Numeric call_function(const FunctionValue& function);
  double call(FunctionId function, std::span<const double> args);
  std::shared_ptr<const Spline> parse_spline();
  Numeric call_spline(const Spline& spline);
  SplineFunction spline_body(const Spline& spline, std::uint32_t component);
  double spline_component_value(const SplineFunction& function, double at);
  Numeric spline_value(const Spline& spline, Spline::Kind kind, double at);
  bool at_spline_kind();
  Spline::Kind parse_spline_kind();
  const Function& at_id(FunctionId id) const { return scene_.functions[id.index]; }

  const LoadOptions& options_;
  const FileAccess& access_;
  SceneQueries& queries_;
  std::size_t asked_size_ = 0;  ///< of the scene's functions and pigments at the last question
  Diagnostics& diagnostics_;
  Scene scene_;
  SourceMap source_map_;
  std::vector<std::string> paths_;  ///< of the programs
  Symbols symbols_;
  Scopes scopes_;
  std::vector<std::shared_ptr<Program>> programs_;  ///< by file number; all are kept
  std::map<std::string, std::shared_ptr<const Program>> cache_;
  ReadImages read_images_;
  std::vector<Frame> frames_;
  std::vector<Block> blocks_;
  const Program* program_ = nullptr;
  const Token* cursor_ = nullptr;   ///< the next token of the program
  const Token* current_ = nullptr;  ///< what peek() returns, if ready_
  bool ready_ = false;
  bool pending_ = false;  ///< an identifier with subscripts has been taken, its value is held here
  Token pending_token_;
  Value pending_value_;
  Binding* pending_binding_ = nullptr;
  Subscripts pending_subscripts_;
  std::string last_name_;
  SourcePosition file_name_at_;  ///< of the file name read last
  const Token* last_ = nullptr;  ///< the token taken last
  // While the value of a declaration is read, directives behind it must wait.
  std::int64_t depth_ = 0;  ///< of braces and parentheses
  struct Bracket {
    char character;
    SourcePosition position;
  };
  std::vector<Bracket> open_;  ///< braces and parentheses that have not been closed
  std::int64_t value_depth_ = -1;
  std::size_t value_blocks_ = 0, value_frames_ = 0;
  std::uint64_t value_begin_ = 0;
  std::uint64_t taken_ = 0;  ///< tokens handed out

  std::uint32_t nesting_ = 0;
  std::uint64_t steps_ = 0, next_check_ = 0;
  std::uint64_t effects_ = 0;          ///< grows with everything that may change a condition
  std::uint32_t calls_ = 0;            ///< depth of functions that call functions
  std::vector<std::uint32_t> levels_;  ///< of each object of the scene
  std::uint64_t written_ = 0;
  std::uint64_t charged_bytes_ = 0;  ///< since memory was looked at
  std::chrono::steady_clock::time_point begin_;
  std::uint64_t first_bytes_ = 0;  ///< of memory in use when the reading began
  double version_ = 3.7;
  bool newer_language_ = false;  ///< 3.8 was asked for
  bool version_given_ = false, gamma_given_ = false;
  std::vector<std::uint32_t> streams_;  ///< states of the random streams
  std::set<std::string> said_;          ///< warnings that are given once
  struct Questioned {
    DescribedPtr described;  ///< kept, so that its address stays its own
    ObjectId id;
  };
  std::map<std::array<double, 3>, std::array<FunctionId, 3>> turbulences_;
  std::map<const Described*, Questioned> questioned_;  ///< only looked up, never walked
};

}  // namespace dioptre::pov
