/// vitrail-tracer: a lowered scene in, an image or one ray's way out.

#include <cstdio>
#include <exception>

#include "app/commands.h"
#include "base/diagnostic.h"

int main(int argc, char** argv) {
  CLI::App app{"Renders lowered Vitrail scenes", "vitrail-tracer"};
  app.require_subcommand(1);
  int exit_code = vitrail::kExitOk;
  vitrail::add_render_command(app, exit_code);
  vitrail::add_trace_command(app, exit_code);
  vitrail::add_validate_command(app, exit_code);
  app.add_subcommand("version", "Print the version")->callback([] { std::puts("vitrail-tracer " VITRAIL_VERSION); });

  // Wrong input and wrong options end alike: a message that names the place, and exit code 2. All else is a failure: a
  // file that cannot be written, a limit met while rendering, a defect.
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& wrong_option) {
    app.exit(wrong_option);
    return vitrail::kExitBadInput;
  } catch (const vitrail::InputError& wrong_input) {
    std::fprintf(stderr, "%s\n", wrong_input.what());
    return vitrail::kExitBadInput;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "vitrail-tracer: %s\n", failure.what());
    return vitrail::kExitFailure;
  }
}
