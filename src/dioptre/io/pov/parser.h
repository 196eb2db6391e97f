// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "dioptre/io/load_scene.h"
#include "dioptre/io/pov/described.h"
#include "dioptre/io/pov/read_images.h"
#include "dioptre/io/pov/token.h"
#include "dioptre/scene/queries.h"
#include "dioptre/scene/scene.h"
#include "dioptre/scene/source_map.h"

namespace dioptre::pov {

/// A number (size 1) or a vector of 2 to 5 components; colours are vectors of 5 (r, g, b, filter,
/// transmit) marked as such.
struct Numeric {
  std::array<double, 5> v{};
  std::uint8_t size = 1;
  bool color = false;
};

/// The scene language's grammar sees this: a stream of tokens in which directives have been carried
/// out and macro calls expanded, expressions on demand, and the scene under construction.
///
/// Errors end the reading by an exception that load_pov catches; it never leaves the library.
class Parser {
 public:
  virtual ~Parser() = default;

  // --- tokens -------------------------------------------------------------------------------
  virtual const Token& peek() = 0;
  virtual Token next() = 0;
  bool at(char c) { return peek().is(c); }
  bool at(Keyword k) { return peek().is(k); }
  bool accept(char c) { return at(c) && (next(), true); }
  bool accept(Keyword k) { return at(k) && (next(), true); }
  /// Takes the token or fails with "expected 'c' TO ..., found ...".
  virtual void expect(char c, std::string_view why = {}) = 0;
  /// Commas between parameters may be left out, as in the language itself.
  void skip_comma() { accept(','); }

  // --- expressions --------------------------------------------------------------------------
  /// True if the next token can begin a number, vector or colour expression (an identifier counts
  /// if it stands for one, or for a function or array of them).
  virtual bool at_expression() = 0;
  virtual Numeric parse_numeric() = 0;  ///< any size, as written
  virtual double parse_float() = 0;
  virtual bool parse_bool() = 0;  ///< a float: on/off, yes/no, true/false, numbers
  /// After a flag keyword: the number that may follow, else true.
  virtual bool parse_flag() = 0;
  virtual Vec2 parse_vec2() = 0;  ///< a float is promoted to all components, in all of these
  virtual Vec3 parse_vec3() = 0;
  /// A colour expression with its keywords (`rgb`, `srgbft`, `color`, `red` ...).
  virtual PigmentColor parse_color() = 0;
  virtual bool at_color() = 0;
  virtual std::string parse_string() = 0;
  virtual bool at_string() = 0;
  /// A string that names a file: in a literal a backslash is a separator, not an escape.
  virtual std::string parse_file_name() = 0;

  // --- identifiers --------------------------------------------------------------------------
  /// If the next tokens name a described thing (an identifier, perhaps with subscripts), takes them
  /// and returns it; else null, and nothing is taken.
  virtual DescribedPtr take_described() = 0;
  /// Looks at what take_described would return, without taking it.
  virtual const Described* peek_described() = 0;
  /// The name of the identifier taken last by take_described.
  virtual const std::string& last_name() const = 0;
  /// After `function`: an identifier, or a body { ... } with optional parameters before it.
  /// `x, y, z` are the parameters if none are given.
  virtual FunctionId parse_function() = 0;
  /// A spline identifier or body's functions, one per component (for prisms of later shapes).
  // --- the scene and the way out ------------------------------------------------------------
  virtual Scene& scene() = 0;
  virtual SourceMap& source_map() = 0;
  virtual SceneQueries& queries() = 0;
  /// The language version that the scene has asked for so far (3.7, 3.5, ...).
  virtual double version() const = 0;
  virtual SourcePosition position() = 0;  ///< of the next token
  /// Counts memory that is about to be taken for one thing against the budgets, and the work of
  /// filling it; fails if it is too much.
  virtual void charge(std::uint64_t bytes) = 0;
  virtual const LoadBudgets& budgets() const = 0;
  /// Fails if the newest object is nested too deep.
  virtual void check_levels() = 0;
  /// The path of an input file found along the search path; fails with the places looked at. If
  /// there is none of that name, each of the endings is tried behind it.
  virtual std::string find_file(const std::string& name,
                                std::span<const std::string_view> endings = {}) = 0;
  /// As find_file, for a font; one of POV-Ray's own stands for a font that is not there.
  virtual std::string find_font(const std::string& name) = 0;
  /// All bytes of a file that find_file gave; fails if there are too many for the budgets.
  virtual std::string read_file(const std::string& path) = 0;
  virtual ReadImages& read_images() = 0;

  [[noreturn]] virtual void fail(std::string message, std::string how_to_mend = {}) = 0;
  [[noreturn]] virtual void fail_at(SourcePosition where, std::string message,
                                    std::string how_to_mend = {}) = 0;
  /// Fails with "expected WHAT, found ...".
  [[noreturn]] virtual void fail_expected(std::string_view what) = 0;
  virtual void warn(std::string message, std::string how_to_mend = {}) = 0;
  virtual void warn_at(SourcePosition where, std::string message, std::string how_to_mend = {}) = 0;
  /// Accepts with a warning, once per place, what POV-Ray 3.7 refuses but has one sensible meaning;
  /// fails if the reading is strict.
  virtual void forgive(SourcePosition where, std::string message, std::string how_to_mend = {}) = 0;
  /// A float of a setting, perhaps with a decimal comma: `0,01`.
  virtual double parse_setting_float() = 0;
  /// If the next token is a name without a meaning that reads so, takes it.
  virtual bool accept_word(std::string_view word) = 0;
  /// Says, once per feature and file, "FEATURE is not rendered yet: ignored".
  virtual void not_rendered(std::string_view feature) = 0;
  /// Guards every recursion: fails when the nesting budget is used up.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) { parser.enter(); }
    ~Nesting() { parser_.leave(); }
    Nesting(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

 protected:
  virtual void enter() = 0;
  virtual void leave() = 0;
};

// What the grammar (syntax/) gives to the token and expression machinery:

/// Reads one item of the top level (an object, a light, camera, settings, ...); fails if the next
/// token begins none.
void parse_scene_item(Parser& parser);
/// If the next token begins a described thing that may be declared (`texture {...}`, `sphere
/// {...}`, `transform {...}`, or an identifier for one), reads it; else null.
DescribedPtr parse_described(Parser& parser);
/// The braces of #default { ... }.
void parse_default(Parser& parser);
/// Inside `function { pattern { ... } }` and `function { pigment { ... } }`, the keyword taken.
Pattern parse_pattern_block(Parser& parser);
Pigment parse_pigment_block(Parser& parser);
/// Puts an object value into the scene (not among the roots) for queries about it.
ObjectId register_object(Parser& parser, const Object& object);

}  // namespace dioptre::pov
