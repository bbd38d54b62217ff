// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiles the integral program's main under another name, for run_command (commands.cpp), because
// the fuzzing program has its own main.
#define main integral_main
#include "integral/cli/main.cpp"
