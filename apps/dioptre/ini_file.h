// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "settings.h"

namespace dioptre::app {

/// Applies an INI file: lines `Key=Value` or switches, `;` comments, `[section]` headings. Lines
/// before the first heading always count, those of a section only if it is asked for. The name may
/// be "file.ini[section]". The error names file and line.
Result<void> read_ini(AppSettings& settings, const std::string& name);

/// Applies the user's standing settings: the first that exists of $POVINI, ./povray.ini,
/// ~/.povray/3.7/povray.ini and /etc/povray/3.7/povray.ini.
Result<void> read_default_ini(AppSettings& settings);

}  // namespace dioptre::app
