// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace anvil {

/// What `anvil` returns to the shell.
enum class ExitCode { success = 0, bad_input = 1, missing_resource = 2, numerical_failure = 3, outside_tolerance = 4 };

/// Base of every error Anvil throws on purpose: a sentence for the user and the exit code it leads to.
class Error : public std::runtime_error {
 public:
  Error(ExitCode exit_code, const std::string& message) : std::runtime_error(message), exit_code_(exit_code) {}
  [[nodiscard]] ExitCode exit_code() const noexcept { return exit_code_; }

 private:
  ExitCode exit_code_;
};

/// A scene, an option or a file that cannot be used as it stands.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// Something the machine lacks: a display, a program, space on the disk.
class MissingResourceError : public Error {
 public:
  explicit MissingResourceError(const std::string& message) : Error(ExitCode::missing_resource, message) {}
};

/// A run that left the domain in which its numbers mean anything.
class NumericalError : public Error {
 public:
  explicit NumericalError(const std::string& message) : Error(ExitCode::numerical_failure, message) {}
};

}  // namespace anvil
