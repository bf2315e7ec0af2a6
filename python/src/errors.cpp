#include "errors.h"

#include "loosefit/base/error.h"

namespace loosefit::python {
namespace {

namespace py = pybind11;
using namespace pybind11::literals;

template <class... Arguments>
void raise(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("loosefit._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(std::forward<Arguments>(arguments)...).ptr());
}

void raise_input(const char* name, const InvalidInput& error) {
  const InputPlace& place = error.place();
  raise(name, error.what(), "hint"_a = error.hint(), "place"_a = place.str(), "file"_a = place.file,
        "line"_a = place.line, "key"_a = place.key, "found"_a = error.found(),
        "expected"_a = error.expected());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const GeometryError& error) {
    raise_input("GeometryError", error);
  } catch (const InvalidInput& error) {
    raise_input("InputError", error);
  } catch (const IoError& error) {
    raise("IoError", error.what(), "hint"_a = error.hint());
  } catch (const SolverFailure& error) {
    raise("SolverFailure", error.what(), "hint"_a = error.hint());
  } catch (const Cancelled& error) {
    raise("Cancelled", error.what());
  } catch (const Error& error) {
    raise("Error", error.what(), "hint"_a = error.hint());
  }
}

}  // namespace

void register_errors() { py::register_exception_translator(translate); }

}  // namespace loosefit::python
