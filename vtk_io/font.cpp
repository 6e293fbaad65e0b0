// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/font.hpp"

#include <fontconfig/fontconfig.h>

#include <memory>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr const char* family = "DejaVu Sans";

struct DestroyPattern {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, DestroyPattern>;

std::string text_of(const Pattern& pattern, const char* property) {
  FcChar8* text = nullptr;
  if (pattern == nullptr || FcPatternGetString(pattern.get(), property, 0, &text) != FcResultMatch) return "";
  return reinterpret_cast<const char*>(text);
}

std::string find_font() {
  FcConfig* const current = nullptr;
  const Pattern wanted(FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans:style=Book")));
  FcConfigSubstitute(current, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(current, wanted.get(), &result));
  // Fontconfig always finds something; only this family has every letter needed.
  if (text_of(found, FC_FAMILY) != family)
    throw MissingResourceError("cannot draw: the font DejaVu Sans is missing. Install the package fonts-dejavu-core");
  return text_of(found, FC_FILE);
}

}  // namespace

const std::string& font_file() {
  static const std::string file = find_font();
  return file;
}

}  // namespace anvil
