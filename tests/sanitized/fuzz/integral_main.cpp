// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral program's main under another name, for run_command (commands.cpp): the fuzzing
// program has one of its own.
#define main integral_main
#include "integral/cli/main.cpp"
