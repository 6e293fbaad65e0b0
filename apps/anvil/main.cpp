// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <system_error>

#include "anvil/core/error.hpp"
#include "anvil/scene/nearest_name.hpp"
#include "anvil/version.hpp"
#include "subcommands.hpp"

namespace anvil {
namespace {

/// EX_SOFTWARE of sysexits.h: an error that Anvil did not foresee. Not one of the codes a script acts upon.
constexpr int exit_code_of_a_fault = 70;

void print_help() {
  fmt::print("Usage: anvil SUBCOMMAND [options]\n\nElastic-plastic waves and impact with smoothed particles.\n\n");
  for (const auto& subcommand : subcommands()) fmt::print("  {:<9} {}\n", subcommand.name, subcommand.summary);
  fmt::print(
      "\n  anvil SUBCOMMAND --help shows the options of one; anvil --version shows the build.\n\n"
      "Exit codes: 0 fine, 1 bad input or usage, 2 something missing on the machine, 3 numerical failure,\n"
      "4 comparison outside tolerance, 70 fault in anvil, 130 or 143 run stopped by a signal.\n");
}

int dispatch(const Arguments& arguments) {
  if (arguments.empty()) throw InputError("name a subcommand; anvil --help lists them");
  const std::string& verb = arguments.front();
  if (verb == "--help" || verb == "-h" || verb == "help") {
    print_help();
    return 0;
  }
  if (verb == "--version") {
    fmt::print("anvil {} ({}, {}, {})\n", version, commit, compiler, build_type);
    return 0;
  }
  std::vector<std::string_view> names;
  for (const auto& subcommand : subcommands()) {
    if (subcommand.name == verb) return subcommand.execute({arguments.begin() + 1, arguments.end()});
    names.push_back(subcommand.name);
  }
  throw InputError(fmt::format("there is no subcommand '{}'{}", verb, suggestion(verb, names)));
}

/// Messages read "anvil: error: ..." and go to standard error, so that results can be piped.
void set_up_messages() {
  spdlog::set_default_logger(spdlog::stderr_logger_st("anvil"));
  spdlog::set_pattern("%n: %l: %v");
}

/// A scene can have several faults: each has its line.
int report(const std::string& message, ExitCode code) {
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) spdlog::error("{}", line);
  return static_cast<int>(code);
}

int execute(const Arguments& arguments) {
  try {
    const int code = dispatch(arguments);
    if (std::fflush(stdout) != 0) return report("cannot write to standard output", ExitCode::missing_resource);
    return code;
  } catch (const Error& error) {
    return report(error.what(), error.exit_code());
  } catch (const std::bad_alloc&) {
    return report("not enough memory on this machine", ExitCode::missing_resource);
  } catch (const std::system_error& error) {
    return report(error.what(), ExitCode::missing_resource);
  } catch (const std::exception& error) {
    spdlog::error("fault in anvil, please report it with the command line: {}", error.what());
    return exit_code_of_a_fault;
  }
}

}  // namespace
}  // namespace anvil

int main(int argc, char** argv) {
  anvil::set_up_messages();
  return anvil::execute({argv + 1, argv + argc});
}
