#include "kinds.hpp"

namespace sbgc::python {

namespace {

template <class T>
py::bytes to_bytes_of(const std::vector<T>& values) {
  // NOLINTNEXTLINE(*-reinterpret-cast): the array of numpy that it becomes has this type
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

void Columns::add(double time, const AnyMessage& message) {
  const auto row = static_cast<std::uint32_t>(times_.size());
  times_.push_back(time);
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.kind == LeafKind::counter || leaf.field.reserved) return;
    std::string path = sbgc::to_string(leaf.path);
    const auto [found, is_new] = places_.try_emplace(path, columns_.size());
    if (is_new) columns_.emplace_back(std::move(path), Column{});
    Column& column = columns_[found->second].second;
    column.rows.push_back(row);
    if (leaf.kind == LeafKind::bytes || leaf.kind == LeafKind::text) {
      column.kind = 'O';
      column.has_texts = leaf.kind == LeafKind::text;
      column.others.emplace_back(leaf.text.begin(), leaf.text.end());
      if (!column.has_texts) column.others.back().assign(leaf.bytes.begin(), leaf.bytes.end());
      return;
    }
    const double raw = leaf.kind == LeafKind::real ? leaf.real
                       : leaf.is_u64 ? static_cast<double>(static_cast<std::uint64_t>(leaf.integer))
                                     : static_cast<double>(leaf.integer);
    column.integers.push_back(leaf.integer);
    column.reals.push_back(leaf.unit != nullptr ? leaf.unit->real(raw) : raw);
    const char kind = leaf.kind == LeafKind::real || leaf.unit != nullptr ? 'f'
                      : leaf.is_u64                                       ? 'u'
                                                                          : 'i';
    // A field that is real in one message, such as a number of an announced type, is real in all.
    if (column.kind != 'f') column.kind = kind;
  });
}

py::tuple Columns::to_python() const {
  py::list columns;
  for (const auto& [path, column] : columns_) {
    py::object values;
    if (column.kind == 'O') {
      py::list others;
      for (const std::string& other : column.others) {
        if (column.has_texts) {
          others.append(py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
              other.data(), static_cast<Py_ssize_t>(other.size()), "surrogateescape")));
        } else {
          others.append(py::bytes(other));
        }
      }
      values = std::move(others);
    } else {
      values = column.kind == 'f' ? to_bytes_of(column.reals) : to_bytes_of(column.integers);
    }
    columns.append(
        py::make_tuple(path, std::string(1, column.kind), to_bytes_of(column.rows), values));
  }
  return py::make_tuple(to_bytes_of(times_), columns);
}

}  // namespace sbgc::python
