#include "errors.h"

#include "loosefit/base/error.h"

namespace loosefit::python {
namespace {

namespace py = pybind11;
using namespace pybind11::literals;

/// Bytes that are no UTF-8 become U+FFFD: a message is to be read, not to fail itself.
py::str readable(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

/// A path as Python has them: such bytes come back when it is used.
py::str as_path(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<Py_ssize_t>(text.size())));
}

template <class... Arguments>
void raise(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("loosefit._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(std::forward<Arguments>(arguments)...).ptr());
}

void raise_input(const char* name, const InvalidInput& error) {
  const InputPlace& place = error.place();
  raise(name, readable(error.what()), "hint"_a = readable(error.hint()),
        "place"_a = readable(place.str()), "file"_a = as_path(place.file), "line"_a = place.line,
        "key"_a = readable(place.key), "found"_a = readable(error.found()),
        "expected"_a = readable(error.expected()));
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const GeometryError& error) {
    raise_input("GeometryError", error);
  } catch (const InvalidInput& error) {
    raise_input("InputError", error);
  } catch (const IoError& error) {
    raise("IoError", readable(error.what()), "hint"_a = readable(error.hint()));
  } catch (const SolverFailure& error) {
    raise("SolverFailure", readable(error.what()), "hint"_a = readable(error.hint()));
  } catch (const Cancelled& error) {
    raise("Cancelled", error.what());
  } catch (const Error& error) {
    raise("Error", readable(error.what()), "hint"_a = readable(error.hint()));
  }
}

}  // namespace

void register_errors() { py::register_exception_translator(translate); }

}  // namespace loosefit::python
