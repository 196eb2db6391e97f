// SPDX-License-Identifier: Apache-2.0
#include "ini_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "command_line.h"

namespace dioptre::app {
namespace {

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// The line up to a `;` that stands outside quotes.
std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"') quoted = !quoted;
    if (line[at] == ';' && !quoted) return line.substr(0, at);
  }
  return line;
}

/// The words of a line of switches; quotes keep blanks within a word.
std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> out;
  std::string word;
  bool quoted = false;
  for (const char c : line + " ") {
    if (c == '"') quoted = !quoted;
    if (quoted || (c != ' ' && c != '\t')) {
      word.push_back(c);
    } else if (!word.empty()) {
      out.push_back(std::move(word));
      word.clear();
    }
  }
  return out;
}

Result<void> apply_line(AppSettings& settings, const std::string& line) {
  const std::size_t equals = line.find('=');
  const bool switches = line[0] == '+' || line[0] == '-';
  if (!switches && equals != std::string::npos) {
    std::string value = trimmed(std::string_view(line).substr(equals + 1));
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
      value = value.substr(1, value.size() - 2);
    }
    return set_option(settings, trimmed(std::string_view(line).substr(0, equals)), value);
  }
  const auto read = read_arguments(settings, words(line));
  if (!read) return fail(read.error().message);
  return {};
}

}  // namespace

Result<void> read_ini(AppSettings& settings, const std::string& name) {
  constexpr std::uint32_t kMaxDepth = 10;
  if (settings.ini_depth >= kMaxDepth) return fail(name + ": INI files are nested too deeply");
  std::string path = name, wanted;
  if (const std::size_t open = name.rfind('['); open != std::string::npos && name.back() == ']') {
    path = name.substr(0, open);
    wanted = to_lower(trimmed(std::string_view(name).substr(open + 1, name.size() - open - 2)));
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return fail(path + ": this is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail("cannot read the INI file " + path);
  ++settings.ini_depth;
  bool active = true, found = wanted.empty();
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::string text = trimmed(without_comment(line));
    if (text.empty()) continue;
    if (text.front() == '[' && text.back() == ']') {
      active = !wanted.empty() &&
               to_lower(trimmed(std::string_view(text).substr(1, text.size() - 2))) == wanted;
      found = found || active;
      continue;
    }
    if (!active) continue;
    if (const auto applied = apply_line(settings, text); !applied) {
      --settings.ini_depth;
      return fail(path + ":" + std::to_string(number) + ": error: " + applied.error().message);
    }
  }
  --settings.ini_depth;
  if (!found) return fail(path + ": it has no section [" + wanted + "]");
  return {};
}

Result<void> read_default_ini(AppSettings& settings) {
  std::vector<std::string> places;
  if (const char* named = std::getenv("POVINI")) places.emplace_back(named);
  places.emplace_back("povray.ini");
  if (const char* home = std::getenv("HOME")) {
    places.push_back(std::string(home) + "/.povray/3.7/povray.ini");
  }
  places.emplace_back("/etc/povray/3.7/povray.ini");
  for (const std::string& place : places) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) return read_ini(settings, place);
  }
  return {};
}

}  // namespace dioptre::app
