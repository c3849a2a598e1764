#include "generator/tools/drawing/layout.hpp"

#include <algorithm>
#include <numeric>

#include "generator/support/diagnostics/utf8.hpp"
#include "generator/tools/drawing/layers.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kLongestText = 40;  // code points

/// Pixels that a text may take in the usual fonts without serifs; generous, as fonts differ.
std::int64_t width_of(const std::string& text, std::int64_t of_character) {
  return static_cast<std::int64_t>(count_code_points(shown(text))) * of_character;
}

/// Of a composite, seen from inside: names of ports at its frame.
bool is_end(const Box& box) {
  return box.kind == BoxKind::entry || box.kind == BoxKind::exit;
}

/// Sizes of a box and the heights of its ports. Inputs and outputs share rows.
PlacedBox measure(const Box& box) {
  PlacedBox placed;
  std::int64_t y = is_end(box) ? 0 : px::header;
  placed.width = std::max(width_of(box.name, 9), width_of(box.subtitle, 7));
  for (std::size_t i = 0; i < std::max(box.inputs.size(), box.outputs.size()); ++i) {
    std::int64_t left = 0, right = 0, height = px::row;
    const auto add = [&](const std::vector<BoxPort>& ports, std::vector<std::int64_t>& at,
                         std::int64_t& width) {
      if (i >= ports.size()) return;
      at.push_back(y + px::row / 2);
      width = std::max(width_of(ports[i].name, 7), width_of(ports[i].detail, 6));
      if (!ports[i].detail.empty()) height = px::row + px::detail;
    };
    add(box.inputs, placed.input_y, left);
    add(box.outputs, placed.output_y, right);
    placed.width = std::max(placed.width, left + right + 2 * px::padding);
    y += height;
  }
  if (box.inside != nullptr) placed.width += 2 * px::padding;  // for the sign that opens it
  placed.width += 2 * px::padding;
  placed.height = y + px::padding / 2;
  return placed;
}

/// Makes a frame wider; its outputs stay at its right edge.
void widen(const Drawing& drawing, Layout& layout, std::int64_t width) {
  constexpr std::size_t kExit = 1;
  const std::int64_t more = width - layout.width;
  if (more <= 0) return;
  layout.width = width;
  layout.boxes[kExit].corner.x += more;
  for (std::size_t w = 0; w < drawing.wires.size(); ++w)
    if (drawing.wires[w].to == kExit) layout.wires[w].points.back().x += more;
}

/// The same of an open composite: a frame around its boxes, with the ports where they are inside.
PlacedBox measure_open(const Box& box) {
  PlacedBox placed;
  Layout inside = layout_of(*box.inside, Composites::open);
  placed.width = std::max(
      inside.width, std::max(width_of(box.name, 9), width_of(box.subtitle, 7)) + 2 * px::padding);
  placed.height = inside.height;
  for (const std::int64_t y : inside.boxes[0].output_y)
    placed.input_y.push_back(inside.boxes[0].corner.y + y);
  for (const std::int64_t y : inside.boxes[1].input_y)
    placed.output_y.push_back(inside.boxes[1].corner.y + y);
  placed.inside.push_back(std::move(inside));
  return placed;
}

/// A box, or the place where a wire passes a layer.
struct Item {
  std::optional<std::size_t> box;
  std::int64_t height = 0, y = 0;
};

/// A piece of a wire from one layer to the next.
struct Piece {
  std::size_t from = 0, to = 0;                 // items
  std::int64_t from_offset = 0, to_offset = 0;  // from their tops
};

class Arrangement {
 public:
  Arrangement(const Drawing& drawing, Composites composites)
      : drawing_(drawing),
        composites_(composites),
        is_frame_(is_end(drawing.boxes.front())),
        layers_(layers_of(drawing)) {}

  Layout arrange() {
    make_items();
    order();
    place_down();
    place_across();
    for (std::size_t w = 0; w < drawing_.wires.size(); ++w) route(w);
    layout_.height += is_frame_ ? px::padding : px::margin;
    return std::move(layout_);
  }

 private:
  void make_items() {
    columns_.resize(layers_.count);
    widths_.resize(layers_.count, 0);
    for (std::size_t b = 0; b < drawing_.boxes.size(); ++b) {
      const Box& box = drawing_.boxes[b];
      const bool open = box.inside != nullptr && composites_ == Composites::open;
      layout_.boxes.push_back(open ? measure_open(box) : measure(box));
      const std::size_t layer = layers_.layer[b];
      widths_[layer] = std::max(widths_[layer], layout_.boxes[b].width);
      add_item(layer, {b, layout_.boxes[b].height, 0});
    }
    passing_.resize(drawing_.wires.size());
    for (std::size_t w = 0; w < drawing_.wires.size(); ++w) add_pieces(w);
    into_.resize(items_.size());
    out_of_.resize(items_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      out_of_[pieces_[p].from].push_back(p);
      into_[pieces_[p].to].push_back(p);
    }
  }

  std::size_t add_item(std::size_t layer, Item item) {
    columns_[layer].push_back(items_.size());
    items_.push_back(item);
    return items_.size() - 1;
  }

  void add_pieces(std::size_t w) {
    const Wire& wire = drawing_.wires[w];
    if (layers_.backwards[w]) return;
    std::size_t from = wire.from;
    std::int64_t offset = layout_.boxes[wire.from].output_y[wire.output];
    for (std::size_t layer = layers_.layer[wire.from] + 1; layer < layers_.layer[wire.to];
         ++layer) {
      const std::size_t item = add_item(layer, {std::nullopt, 0, 0});
      passing_[w].push_back(item);
      pieces_.push_back({from, item, offset, 0});
      from = item;
      offset = 0;
    }
    pieces_.push_back({from, wire.to, offset, layout_.boxes[wire.to].input_y[wire.input]});
  }

  /// By the mean place of neighbours, to and fro.
  void order() {
    std::vector<std::size_t> rank(items_.size());
    const auto number = [&](std::size_t layer) {
      for (std::size_t i = 0; i < columns_[layer].size(); ++i) rank[columns_[layer][i]] = i;
    };
    for (std::size_t layer = 0; layer < layers_.count; ++layer) number(layer);
    constexpr int kSweeps = 12;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      const bool forward = sweep % 2 == 0;
      for (std::size_t i = 1; i < layers_.count; ++i) {
        const std::size_t layer = forward ? i : layers_.count - 1 - i;
        sort_by_neighbours(columns_[layer], forward, rank);
        number(layer);
      }
    }
  }

  void sort_by_neighbours(std::vector<std::size_t>& column, bool by_senders,
                          const std::vector<std::size_t>& rank) {
    std::vector<std::pair<double, std::size_t>> keys;  // mean, item
    for (const std::size_t item : column) {
      const auto& pieces = by_senders ? into_[item] : out_of_[item];
      double sum = 0.0;
      for (const std::size_t p : pieces) {
        const std::size_t other = by_senders ? pieces_[p].from : pieces_[p].to;
        const std::int64_t offset = by_senders ? pieces_[p].from_offset : pieces_[p].to_offset;
        // Ports of one box in their order, within its rank.
        const auto within =
            static_cast<double>(offset) /
            static_cast<double>(std::max<std::int64_t>(items_[other].height, 1) + 1);
        sum += static_cast<double>(rank[other]) + within;
      }
      const auto own = static_cast<double>(rank[item]);
      keys.emplace_back(pieces.empty() ? own : sum / static_cast<double>(pieces.size()), item);
    }
    std::ranges::stable_sort(keys, {}, &std::pair<double, std::size_t>::first);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = keys[i].second;
  }

  /// Heights: each column as near to its neighbours as its order allows, to and fro.
  void place_down() {
    for (const auto& column : columns_) {
      std::int64_t y = 0;
      for (const std::size_t item : column) {
        items_[item].y = y;
        y += items_[item].height + px::between_boxes;
      }
    }
    constexpr int kSweeps = 16;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      const bool forward = sweep % 2 == 0;
      for (std::size_t i = 0; i < layers_.count; ++i)
        settle(columns_[forward ? i : layers_.count - 1 - i]);
    }
    std::int64_t top = items_.front().y;  // of the actions: there is always an item
    for (const Item& item : items_) top = std::min(top, item.y);
    for (Item& item : items_) item.y += (is_frame_ ? px::header : px::margin) - top;
    for (const Item& item : items_) layout_.height = std::max(layout_.height, item.y + item.height);
  }

  /// Where the item would stand if it were alone, and how much it insists.
  std::pair<std::int64_t, std::int64_t> wish_of(std::size_t item) const {
    std::int64_t sum = 0, count = 0;
    for (const std::size_t p : into_[item]) {
      const Piece& piece = pieces_[p];
      sum += items_[piece.from].y + piece.from_offset - piece.to_offset;
      ++count;
    }
    for (const std::size_t p : out_of_[item]) {
      const Piece& piece = pieces_[p];
      sum += items_[piece.to].y + piece.to_offset - piece.from_offset;
      ++count;
    }
    if (count == 0) return {items_[item].y, 1};
    // A wire that passes wants to be straight more than a box wants to be near.
    return {sum / count, items_[item].box ? count : 4 * count};
  }

  /// The least sum of squared distances from the wishes that keeps the order: isotonic regression
  /// by pooling neighbours (Ayer et al., 1955).
  void settle(const std::vector<std::size_t>& column) {
    struct Pool {
      std::int64_t sum, weight;
      std::size_t size;
      std::int64_t mean() const { return sum / weight; }
    };
    std::vector<Pool> pools;
    std::int64_t offset = 0;
    for (const std::size_t item : column) {
      const auto [wish, weight] = wish_of(item);
      pools.push_back({(wish - offset) * weight, weight, 1});
      while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
        const Pool last = pools.back();
        pools.pop_back();
        pools.back().sum += last.sum;
        pools.back().weight += last.weight;
        pools.back().size += last.size;
      }
      offset += items_[item].height + px::between_boxes;
    }
    std::size_t at = 0;
    offset = 0;
    for (const Pool& pool : pools) {
      for (std::size_t i = 0; i < pool.size; ++i, ++at) {
        items_[column[at]].y = pool.mean() + offset;
        offset += items_[column[at]].height + px::between_boxes;
      }
    }
  }

  void place_across() {
    std::int64_t x = is_frame_ ? 0 : px::margin;
    lefts_.resize(layers_.count);
    used_left_.resize(layers_.count, 0);
    used_right_.resize(layers_.count, 0);
    std::vector<std::int64_t> before(layers_.count, 0), after(layers_.count, 0);
    for (std::size_t w = 0; w < drawing_.wires.size(); ++w) {
      if (!layers_.backwards[w]) continue;
      before[layers_.layer[drawing_.wires[w].to]] += px::lane;
      after[layers_.layer[drawing_.wires[w].from]] += px::lane;
    }
    for (std::size_t layer = 0; layer < layers_.count; ++layer) {
      x += before[layer];
      lefts_[layer] = x;
      x += widths_[layer] + after[layer] + (layer + 1 < layers_.count ? px::between_layers : 0);
    }
    layout_.width = x + (is_frame_ ? 0 : px::margin);
    lane_y_ = layout_.height + px::lane;
    for (const Item& item : items_) {
      if (!item.box) continue;
      PlacedBox& box = layout_.boxes[*item.box];
      box.corner = {lefts_[layers_.layer[*item.box]], item.y};
      box.width = widths_[layers_.layer[*item.box]];
      if (!box.inside.empty())
        widen(*drawing_.boxes[*item.box].inside, box.inside.front(), box.width);
    }
  }

  void route(std::size_t w) {
    const Wire& wire = drawing_.wires[w];
    const PlacedBox& from = layout_.boxes[wire.from];
    const PlacedBox& to = layout_.boxes[wire.to];
    const Point begin{from.corner.x + from.width, from.corner.y + from.output_y[wire.output]};
    const Point end{to.corner.x, to.corner.y + to.input_y[wire.input]};
    PlacedWire placed;
    placed.backwards = layers_.backwards[w];
    placed.points.push_back(begin);
    if (placed.backwards) {
      const std::int64_t right = begin.x + px::lane * ++used_right_[layers_.layer[wire.from]];
      const std::int64_t left = end.x - px::lane * ++used_left_[layers_.layer[wire.to]];
      for (const Point& point :
           {Point{right, begin.y}, {right, lane_y_}, {left, lane_y_}, {left, end.y}})
        placed.points.push_back(point);
      layout_.height = std::max(layout_.height, lane_y_);
      lane_y_ += px::lane;
    }
    std::size_t layer = layers_.layer[wire.from];
    for (const std::size_t item : passing_[w]) {
      ++layer;
      placed.points.push_back({lefts_[layer], items_[item].y});
      placed.points.push_back({lefts_[layer] + widths_[layer], items_[item].y});
    }
    placed.points.push_back(end);
    layout_.wires.push_back(std::move(placed));
  }

  const Drawing& drawing_;
  const Composites composites_;
  const bool is_frame_;  // of what is within a composite
  const Layers layers_;
  Layout layout_;
  std::vector<Item> items_;  // the boxes first
  std::vector<Piece> pieces_;
  std::vector<std::vector<std::size_t>> columns_;        // items of each layer, from above
  std::vector<std::vector<std::size_t>> passing_;        // items of each wire
  std::vector<std::vector<std::size_t>> into_, out_of_;  // pieces of each item
  std::vector<std::int64_t> widths_, lefts_;             // of each layer
  std::vector<std::int64_t> used_left_, used_right_;     // tracks next to each layer
  std::int64_t lane_y_ = 0;
};

}  // namespace

std::string shown(const std::string& text) {
  if (count_code_points(text) <= kLongestText) return text;
  std::size_t at = 0;
  for (std::size_t i = 0; i + 1 < kLongestText; ++i) at += decode_utf8(text, at).size;
  return text.substr(0, at) + "…";
}

Layout layout_of(const Drawing& drawing, Composites composites) {
  return Arrangement(drawing, composites).arrange();
}

}  // namespace eagerx::gen
