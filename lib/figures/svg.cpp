// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstdint>
#include <iterator>

#include "anvil/figures/drawing.hpp"

namespace anvil {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string hex(const Color& color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }

std::string base64(std::string bytes) {
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.append(missing, '\0');
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Letters(bytes.begin()), Letters(bytes.end()));
  text.replace(text.size() - missing, missing, missing, '=');
  return text;
}

/// A Windows bitmap, the simplest picture that every browser reads: rows from below, padded to four bytes.
std::string bitmap(const DrawnImage& image) {
  std::string bytes;
  const auto add = [&bytes](std::uint32_t number, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>((number >> (8 * i)) & 0xFFU);
  };
  constexpr std::uint32_t header = 54;
  const auto width = static_cast<std::uint32_t>(image.columns);
  const auto height = static_cast<std::uint32_t>(image.rows);
  const std::uint32_t padding = (4 - (3 * width) % 4) % 4;
  const std::uint32_t size = (3 * width + padding) * height;
  bytes += "BM";
  for (const std::uint32_t number : {header + size, 0U, header, 40U, width, height}) add(number, 4);
  add(1, 2);   // planes
  add(24, 2);  // bits per pixel
  for (const std::uint32_t number : {0U, size, 2835U, 2835U, 0U, 0U}) add(number, 4);
  for (std::size_t row = 0; row < image.rows; ++row) {
    for (std::size_t column = 0; column < image.columns; ++column) {
      const Color& color = image.cells[row * image.columns + column];
      add(color.blue, 1);
      add(color.green, 1);
      add(color.red, 1);
    }
    add(0, static_cast<int>(padding));
  }
  return bytes;
}

/// Writes one shape after the other; y runs down in SVG.
class SvgWriter {
 public:
  explicit SvgWriter(const Drawing& drawing) : height_(drawing.size[1]) {
    text_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"DejaVu Sans, Verdana, sans-serif\" fill=\"#1a1a1a\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        drawing.size[0], drawing.size[1]);
    for (const auto& shape : drawing.shapes) std::visit(*this, shape);
    text_ += "</svg>\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

  void operator()(const DrawnLine& line) {
    const std::string clip = clip_reference(line.clip);
    text_ += fmt::format(
        "<polyline{} fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" stroke-linejoin=\"round\" points=\"", clip,
        hex(line.color), line.width);
    for (const Dot& dot : line.dots) text_ += fmt::format("{:.2f},{:.2f} ", dot.x, height_ - dot.y);
    text_ += "\"/>\n";
  }

  void operator()(const DrawnPoints& points) {
    const std::string clip = clip_reference(points.clip);
    text_ += fmt::format("<g{} fill=\"{}\">\n", clip, hex(points.color));
    for (const Dot& dot : points.dots)
      text_ +=
          fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.4g}\"/>\n", dot.x, height_ - dot.y, points.radius);
    text_ += "</g>\n";
  }

  void operator()(const DrawnText& text) {
    const char* const anchors[] = {"start", "middle", "end"};
    const double x = text.at.x;
    const double y = height_ - text.at.y;
    const std::string turn = text.upright ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y) : "";
    text_ += fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" dy=\"0.36em\" font-size=\"{:.4g}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
        text.size, anchors[static_cast<int>(text.anchor)], turn, escaped(text.text));
  }

  void operator()(const DrawnImage& image) {
    text_ += fmt::format(
        "<image{} preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
        "href=\"data:image/bmp;base64,{}\"/>\n",
        position_of(image.box), base64(bitmap(image)));
  }

 private:
  [[nodiscard]] std::string position_of(const Box& box) const {
    return fmt::format(" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"", box.left, height_ - box.top,
                       box.width(), box.height());
  }

  /// Adds a clip path and returns the attribute that names it.
  std::string clip_reference(const std::optional<Box>& clip) {
    if (!clip) return "";
    ++clips_;
    text_ += fmt::format("<clipPath id=\"clip{}\"><rect{}/></clipPath>\n", clips_, position_of(*clip));
    return fmt::format(" clip-path=\"url(#clip{})\"", clips_);
  }

  double height_;
  int clips_ = 0;
  std::string text_;
};

}  // namespace

std::string write_svg(const Drawing& drawing) { return SvgWriter(drawing).text(); }

}  // namespace anvil
