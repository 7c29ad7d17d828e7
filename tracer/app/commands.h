#pragma once
/// The subcommands; each registers its own options and stores the exit code of its run.

#include <CLI/CLI.hpp>

namespace vitrail {

/// As tracer/README.md promises them.
inline constexpr int kExitOk = 0, kExitFailure = 1, kExitBadInput = 2, kExitInterrupted = 130;

void add_render_command(CLI::App& app, int& exit_code);
void add_trace_command(CLI::App& app, int& exit_code);
void add_validate_command(CLI::App& app, int& exit_code);

}  // namespace vitrail
