// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/figures/text_width.hpp"

namespace anvil {
namespace {

/// In units of the font size: the advance widths of DejaVu Sans, by groups of similar letters.
double letter_width(unsigned char letter) {
  constexpr std::string_view narrow = "iIjl.,:;'| ";
  constexpr std::string_view slim = "frt()[]/-\"";
  constexpr std::string_view wide = "mMwW%@";
  const auto contains = [letter](std::string_view group) {
    return group.find(static_cast<char>(letter)) != std::string_view::npos;
  };
  if (contains(narrow)) return 0.31;
  if (contains(slim)) return 0.40;
  if (contains(wide)) return 0.95;
  if (letter >= 'A' && letter <= 'Z') return 0.70;
  return 0.63;  // digits, small letters, and what is not ASCII
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80) width += letter_width(byte);  // the first byte of each character
  }
  return width * size;
}

}  // namespace anvil
