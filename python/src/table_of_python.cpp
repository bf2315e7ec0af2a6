#include "table_of_python.h"

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::python {
namespace {

namespace py = pybind11;
using Kind = io::ConfigNode::Kind;

constexpr int kMaxDepth = 32;  // as of TOML files: io/toml_file.cpp

bool is_a(py::handle value, const char* module, const char* name) {
  return py::isinstance(value, py::module_::import(module).attr(name));
}

/// A scenario is UTF-8, and so are the paths in it. \pre `value` is a str
std::string utf8_of(py::handle value, const std::string& key) {
  Py_ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (text) return {text, static_cast<std::size_t>(size)};
  PyErr_Clear();
  const auto ascii = py::reinterpret_steal<py::str>(PyObject_ASCII(value.ptr()));
  throw InvalidInput({"", 0, key}, printable(std::string(ascii), 100), "text that is UTF-8");
}

io::ConfigNode node_of(py::handle value, const std::string& key, int depth);

io::ConfigNode table_of(py::handle mapping, const std::string& key, int depth) {
  io::ConfigNode node;
  node.kind = Kind::table;
  for (const py::handle item : mapping.attr("items")()) {
    const auto pair = py::reinterpret_borrow<py::tuple>(item);
    if (!PyUnicode_Check(pair[0].ptr()))
      throw InvalidInput({"", 0, key}, "the key " + printable(std::string(py::repr(pair[0])), 100),
                         "keys that are str");
    const std::string name = utf8_of(pair[0], key);
    const std::string full = (key.empty() ? "" : key + ".") + printable(name, 100);
    node.members.emplace_back(name, node_of(pair[1], full, depth + 1));
  }
  return node;
}

io::ConfigNode array_of(py::handle sequence, const std::string& key, int depth) {
  io::ConfigNode node;
  node.kind = Kind::array;
  for (const py::handle item : sequence)
    node.items.push_back(
        node_of(item, key + "[" + std::to_string(node.items.size()) + "]", depth + 1));
  return node;
}

io::ConfigNode integer_of(py::handle value, const std::string& key) {
  io::ConfigNode node;
  node.kind = Kind::integer;
  int overflow = 0;
  node.integer = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0)
    throw InvalidInput({"", 0, key}, "an integer beyond 64 bits", "a smaller number");
  node.number = static_cast<double>(node.integer);
  return node;
}

io::ConfigNode text_of(std::string text) {
  io::ConfigNode node;
  node.kind = Kind::text;
  node.text = std::move(text);
  return node;
}

io::ConfigNode node_of(py::handle value, const std::string& key, int depth) {
  if (depth > kMaxDepth)
    throw InvalidInput({"", 0, key}, "values nested more than 32 deep",
                       "a flat table of sections and keys");
  if (value.is_none())
    throw InvalidInput({"", 0, key}, "None", "a value", "leave the key out for its default");
  PyObject* const object = value.ptr();
  io::ConfigNode node;
  if (PyBool_Check(object)) {
    node.kind = Kind::boolean;
    node.boolean = object == Py_True;
    return node;
  }
  if (PyLong_Check(object)) return integer_of(value, key);
  if (PyFloat_Check(object)) {
    node.kind = Kind::number;
    node.number = PyFloat_AsDouble(object);
    return node;
  }
  if (PyUnicode_Check(object)) return text_of(utf8_of(value, key));
  if (is_a(value, "collections.abc", "Mapping")) return table_of(value, key, depth);
  if (PyList_Check(object) || PyTuple_Check(object)) return array_of(value, key, depth);
  // NumPy's arrays and scalars turn into what they hold.
  if (py::hasattr(value, "tolist")) return node_of(value.attr("tolist")(), key, depth + 1);
  if (is_a(value, "os", "PathLike"))
    return text_of(utf8_of(py::module_::import("os").attr("fsdecode")(value), key));
  node.kind = Kind::other;
  node.text = printable(py::type::of(value).attr("__name__").cast<std::string>(), 60);
  return node;
}

}  // namespace

io::ConfigNode table_of_python(py::handle mapping) { return table_of(mapping, "", 0); }

}  // namespace loosefit::python
