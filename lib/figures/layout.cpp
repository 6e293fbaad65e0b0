// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/figures/axis_scale.hpp"
#include "anvil/figures/color_scale.hpp"
#include "anvil/figures/drawing.hpp"
#include "anvil/figures/text_width.hpp"

namespace anvil {
namespace {

constexpr Color ink{26, 26, 26};
constexpr Color reference_grey{150, 150, 150};

/// Sizes in pixels. They are made for a panel of 1600 x 1200 and shrink with smaller ones, letters less than the panel.
struct Sizes {
  double title, label, number;  // fonts
  double gap, tick, frame;
  double curve, reference, point;

  static Sizes for_panel(double width, double height) {
    const double share = std::min(width / 1600.0, height / 1000.0);
    const double s = share < 1.0 ? std::pow(share, 0.65) : 1.0;
    return {36 * s, 34 * s, 30 * s, 18 * s, 14 * s, 2.5 * s, 3.5 * s, 9 * s, 5 * s};
  }
};

struct LegendEntry {
  const PlottedCurve* curve;
  std::size_t row;
  double offset;  // from the left of the frame
};

class PanelLayout {
 public:
  PanelLayout(const Panel& panel, const Box& cell, Drawing& drawing)
      : panel_(panel),
        cell_(cell),
        drawing_(drawing),
        sizes_(Sizes::for_panel(cell.width(), cell.height())),
        x_scale_(panel.x, all_values(&PlottedCurve::x, &PlottedMap::x), true, intervals(cell.width(), 8)),
        y_scale_(panel.y, all_values(&PlottedCurve::y, &PlottedMap::y), panel.map.has_value(),
                 intervals(cell.height(), 6)) {}

  /// What the panel needs beside its frame: numbers and labels.
  [[nodiscard]] double left_margin() const {
    const double gap = sizes_.gap;
    return gap + sizes_.label + 1.5 * gap + widest_number(y_scale_) + gap;
  }
  [[nodiscard]] double right_margin() const {
    const double gap = sizes_.gap;
    double margin = 2.0 * gap + 0.5 * widest_number(x_scale_);
    if (panel_.map) margin += color_bar_width() + 5.0 * gap + widest_number(color_axis());
    return margin;
  }

  void draw(double left_margin, double right_margin) {
    left_margin_ = left_margin;
    frame_.left = cell_.left + left_margin;
    frame_.right = cell_.right - right_margin;
    place_frame();
    if (panel_.equal_scales) shrink_frame();
    if (panel_.map) draw_map(*panel_.map);
    for (const bool reference : {true, false})
      for (const auto& curve : panel_.curves)
        if ((curve.style == CurveStyle::reference) == reference) draw_curve(curve);
    for (const auto& curve : panel_.curves) draw_point_labels(curve);
    draw_frame();
    draw_ticks();
    draw_titles();
    for (const auto& entry : legend_) draw_legend_entry(entry);
  }

 private:
  /// As many as leave room between the numbers of an axis.
  [[nodiscard]] int intervals(double length, int most) const {
    return std::clamp(static_cast<int>(length / (5.5 * sizes_.number)), 2, most);
  }

  [[nodiscard]] std::vector<double> all_values(std::vector<double> PlottedCurve::*of_curve,
                                               std::array<double, 2> PlottedMap::*of_map) const {
    std::vector<double> values;
    for (const auto& curve : panel_.curves)
      values.insert(values.end(), (curve.*of_curve).begin(), (curve.*of_curve).end());
    if (panel_.map) values.insert(values.end(), ((*panel_.map).*of_map).begin(), ((*panel_.map).*of_map).end());
    return values;
  }

  [[nodiscard]] double widest_number(const AxisScale& scale) const {
    double width = 0.0;
    for (const Tick& tick : scale.ticks()) width = std::max(width, text_width(tick.label, sizes_.number));
    return width;
  }

  void place_frame() {
    const double gap = sizes_.gap;
    frame_.bottom = cell_.bottom + gap + sizes_.label + gap + sizes_.number + gap;
    double top = cell_.top - gap;
    if (!panel_.title.empty()) top -= sizes_.title + gap;
    title_bottom_ = top;
    place_legend();
    frame_.top = top - static_cast<double>(legend_rows_) * legend_row_height() - (legend_rows_ > 0 ? 0.5 * gap : 0.0) -
                 0.5 * sizes_.number;
    if (panel_.map) frame_.top -= sizes_.number + gap;  // the label of the colour bar
    if (frame_.width() < 4.0 * gap || frame_.height() < 4.0 * gap)
      throw InputError("the figure is too small for its panels; make it larger or give it fewer of them");
  }

  /// To equal scales; what it does not need any more stays free below and on both sides.
  void shrink_frame() {
    const double pixels = std::min(frame_.width() / x_scale_.span(), frame_.height() / y_scale_.span());
    const double spare = frame_.width() - pixels * x_scale_.span();
    frame_.left += 0.5 * spare;
    frame_.right -= 0.5 * spare;
    frame_.bottom = frame_.top - pixels * y_scale_.span();
  }

  [[nodiscard]] double legend_row_height() const { return 1.45 * sizes_.number; }
  [[nodiscard]] double legend_sample() const { return 2.2 * sizes_.number; }
  [[nodiscard]] double color_bar_width() const { return 1.6 * sizes_.number; }
  [[nodiscard]] AxisScale color_axis() const {
    return {{.label = panel_.map->label, .range = panel_.map->range}, {}, true, 6};
  }

  void place_legend() {
    double offset = 0.0;
    std::size_t row = 0;
    for (const auto& curve : panel_.curves) {
      if (curve.label.empty()) continue;
      const double width = legend_sample() + sizes_.gap + text_width(curve.label, sizes_.number) + 2.0 * sizes_.gap;
      if (offset > 0.0 && offset + width > frame_.right - frame_.left) {
        offset = 0.0;
        ++row;
      }
      legend_.push_back({&curve, row, offset});
      offset += width;
    }
    legend_rows_ = legend_.empty() ? 0 : row + 1;
  }

  [[nodiscard]] Dot dot_at(double x_share, double y_share) const {
    return {frame_.left + x_share * frame_.width(), frame_.bottom + y_share * frame_.height()};
  }

  /// Values far outside would not survive the single precision of some painters.
  [[nodiscard]] static double near(double share) { return std::clamp(share, -100.0, 100.0); }

  void add_line(std::vector<Dot> dots, const Color& color, double width, bool clipped) {
    drawing_.shapes.emplace_back(
        DrawnLine{std::move(dots), color, width, clipped ? std::optional<Box>(frame_) : std::nullopt});
  }

  /// Few points stand alone; many are particles beside each other.
  [[nodiscard]] double point_radius(const PlottedCurve& curve) const {
    constexpr std::size_t few = 200;
    return (curve.x.size() < few ? 1.7 : 1.0) * sizes_.point;
  }

  void draw_curve(const PlottedCurve& curve) {
    const bool reference = curve.style == CurveStyle::reference;
    const Color color = reference ? reference_grey : curve.color;
    std::vector<Dot> dots;
    const auto flush = [&] {
      if (curve.style == CurveStyle::points)
        drawing_.shapes.emplace_back(DrawnPoints{dots, color, curve.point_size * point_radius(curve), frame_});
      else if (dots.size() > 1)
        add_line(dots, color, reference ? sizes_.reference : sizes_.curve, true);
      dots.clear();
    };
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double x = x_scale_.share_of(curve.x[i]);
      const double y = y_scale_.share_of(curve.y[i]);
      if (std::isfinite(x) && std::isfinite(y))
        dots.push_back(dot_at(near(x), near(y)));
      else
        flush();
    }
    flush();
  }

  /// To the upper right of each point; those that would cover another one, or leave the frame, are left out.
  void draw_point_labels(const PlottedCurve& curve) {
    const double size = 0.8 * sizes_.number;
    for (std::size_t i = 0; i < curve.point_labels.size(); ++i) {
      const double x = x_scale_.share_of(curve.x[i]);
      const double y = y_scale_.share_of(curve.y[i]);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      const Dot dot = dot_at(near(x), near(y));
      const Dot at{dot.x + 0.4 * size, dot.y + 0.8 * size};
      const Box box{at.x, at.y - 0.5 * size, at.x + text_width(curve.point_labels[i], size), at.y + 0.5 * size};
      const auto covers = [&](const Box& other) {
        return box.left < other.right && other.left < box.right && box.bottom < other.top && other.bottom < box.top;
      };
      if (box.right > frame_.right || box.top > frame_.top || std::ranges::any_of(label_boxes_, covers)) continue;
      label_boxes_.push_back(box);
      add_text(curve.point_labels[i], at, size, Anchor::left);
    }
  }

  void draw_map(const PlottedMap& map) {
    const Dot low = dot_at(x_scale_.share_of(map.x[0]), y_scale_.share_of(map.y[0]));
    const Dot high = dot_at(x_scale_.share_of(map.x[1]), y_scale_.share_of(map.y[1]));
    DrawnImage image{{low.x, low.y, high.x, high.y}, map.columns, map.rows, {}};
    for (const double value : map.values) image.cells.push_back(color_of(value, map.range));
    drawing_.shapes.emplace_back(std::move(image));
    draw_color_bar(map);
  }

  void draw_color_bar(const PlottedMap& map) {
    constexpr std::size_t steps = 256;
    const double left = frame_.right + 2.0 * sizes_.gap;
    const Box bar{left, frame_.bottom, left + color_bar_width(), frame_.top};
    DrawnImage colors{bar, 1, steps, {}};
    for (std::size_t i = 0; i < steps; ++i)
      colors.cells.push_back(
          color_of(map.range[0] + (map.range[1] - map.range[0]) * static_cast<double>(i) / (steps - 1.0), map.range));
    drawing_.shapes.emplace_back(std::move(colors));
    add_outline(bar);
    const AxisScale axis = color_axis();
    for (const Tick& tick : axis.ticks()) {
      const double y = bar.bottom + tick.share * bar.height();
      add_line({{bar.right, y}, {bar.right + 0.5 * sizes_.tick, y}}, ink, sizes_.frame, false);
      add_text(tick.label, {bar.right + sizes_.tick, y}, sizes_.number, Anchor::left);
    }
    add_text(map.label, {cell_.right - sizes_.gap, bar.top + sizes_.gap + 0.6 * sizes_.number}, sizes_.number,
             Anchor::right);
  }

  void add_text(const std::string& text, const Dot& at, double size, Anchor anchor, bool upright = false) {
    if (!text.empty()) drawing_.shapes.emplace_back(DrawnText{text, at, size, anchor, upright});
  }

  void add_outline(const Box& box) {
    add_line({{box.left, box.bottom},
              {box.right, box.bottom},
              {box.right, box.top},
              {box.left, box.top},
              {box.left, box.bottom}},
             ink, sizes_.frame, false);
  }

  void draw_frame() { add_outline(frame_); }

  /// Inside the frame, on all four sides; numbers below and on the left.
  void draw_ticks() {
    for (const Tick& tick : x_scale_.ticks()) {
      const double length = tick.label.empty() ? 0.5 * sizes_.tick : sizes_.tick;
      const double x = dot_at(tick.share, 0.0).x;
      add_line({{x, frame_.bottom}, {x, frame_.bottom + length}}, ink, sizes_.frame, false);
      add_line({{x, frame_.top}, {x, frame_.top - length}}, ink, sizes_.frame, false);
      add_text(tick.label, {x, frame_.bottom - sizes_.gap - 0.4 * sizes_.number}, sizes_.number, Anchor::centre);
    }
    for (const Tick& tick : y_scale_.ticks()) {
      const double length = tick.label.empty() ? 0.5 * sizes_.tick : sizes_.tick;
      const double y = dot_at(0.0, tick.share).y;
      add_line({{frame_.left, y}, {frame_.left + length, y}}, ink, sizes_.frame, false);
      add_line({{frame_.right, y}, {frame_.right - length, y}}, ink, sizes_.frame, false);
      add_text(tick.label, {frame_.left - sizes_.gap, y}, sizes_.number, Anchor::right);
    }
  }

  void draw_titles() {
    const double middle = 0.5 * (frame_.left + frame_.right);
    add_text(panel_.title, {middle, title_bottom_ + 0.5 * sizes_.title}, sizes_.title, Anchor::centre);
    const double below = frame_.bottom - 2.0 * sizes_.gap - sizes_.number - 0.5 * sizes_.label;
    add_text(panel_.x.label, {middle, below}, sizes_.label, Anchor::centre);
    add_text(panel_.y.label,
             {frame_.left - left_margin_ + sizes_.gap + 0.5 * sizes_.label, 0.5 * (frame_.bottom + frame_.top)},
             sizes_.label, Anchor::centre, true);
  }

  void draw_legend_entry(const LegendEntry& entry) {
    const PlottedCurve& curve = *entry.curve;
    const double left = frame_.left + entry.offset;
    const double y = title_bottom_ - (static_cast<double>(entry.row) + 0.5) * legend_row_height();
    const Dot end{left + legend_sample(), y};
    if (curve.style == CurveStyle::points)
      drawing_.shapes.emplace_back(
          DrawnPoints{{{0.5 * (left + end.x), y}}, curve.color, point_radius(curve), std::nullopt});
    else if (curve.style == CurveStyle::reference)
      add_line({{left, y}, end}, reference_grey, sizes_.reference, false);
    else
      add_line({{left, y}, end}, curve.color, sizes_.curve, false);
    add_text(curve.label, {end.x + sizes_.gap, y}, sizes_.number, Anchor::left);
  }

  const Panel& panel_;
  Box cell_;
  Drawing& drawing_;
  Sizes sizes_;
  AxisScale x_scale_, y_scale_;
  Box frame_;
  double left_margin_ = 0.0, title_bottom_ = 0.0;
  std::vector<LegendEntry> legend_;
  std::size_t legend_rows_ = 0;
  std::vector<Box> label_boxes_;
};

void check_figure(const Figure& figure) {
  constexpr int smallest = 200;
  constexpr int largest = 8192;
  for (const int pixels : figure.size)
    if (pixels < smallest || pixels > largest)
      throw InputError(fmt::format("a figure of {} x {} pixels is not possible: expected {} to {} on each side",
                                   figure.size[0], figure.size[1], smallest, largest));
  if (figure.panels.empty()) throw InputError("the figure has no panel");
  if (figure.columns < 1) throw InputError("a figure has at least one column");
}

}  // namespace

Drawing lay_out(const Figure& figure) {
  check_figure(figure);
  Drawing drawing{figure.size, {}};
  const auto columns = std::min(static_cast<std::size_t>(figure.columns), figure.panels.size());
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  const double full_width = figure.size[0];
  double full_height = figure.size[1];
  if (!figure.title.empty()) {
    double size = 38.0 * std::min(1.0, full_width / 1600.0);
    size *= std::min(1.0, 0.96 * full_width / text_width(figure.title, size));
    full_height -= 2.0 * size;
    drawing.shapes.emplace_back(
        DrawnText{figure.title, {0.5 * full_width, full_height + 0.8 * size}, size, Anchor::centre});
  }
  const double width = full_width / static_cast<double>(columns);
  const double height = full_height / static_cast<double>(rows);
  std::vector<PanelLayout> panels;
  panels.reserve(figure.panels.size());
  // Panels one below the other have their frames in line.
  std::vector<std::array<double, 2>> margins(columns, {0.0, 0.0});
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const double left = width * static_cast<double>(i % columns);
    const std::size_t row = i / columns;
    const double top = full_height - height * static_cast<double>(row);
    panels.emplace_back(figure.panels[i], Box{left, top - height, left + width, top}, drawing);
    auto& [left_margin, right_margin] = margins[i % columns];
    left_margin = std::max(left_margin, panels.back().left_margin());
    right_margin = std::max(right_margin, panels.back().right_margin());
  }
  for (std::size_t i = 0; i < panels.size(); ++i) panels[i].draw(margins[i % columns][0], margins[i % columns][1]);
  return drawing;
}

}  // namespace anvil
