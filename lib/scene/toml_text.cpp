// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/toml_text.hpp"

#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>
#include <string_view>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

/// The parser's reason in plain words.
std::string plain_reason(std::string reason) {
  constexpr std::string_view prefix = "Error while parsing ";
  if (reason.starts_with(prefix)) reason.replace(0, prefix.size(), "cannot read this ");
  boost::replace_all(reason, "'\\n'", "the end of the line");
  if (reason.find("unescaped control characters") != std::string::npos)
    reason = "a text does not end; is a quote missing?";
  if (reason.find("could not determine value type") != std::string::npos) reason += "; does a text lack its quotes?";
  return reason;
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: not valid TOML: {}", file, begin.line, begin.column,
                                 plain_reason(std::string(error.description()))));
  }
}

}  // namespace anvil
