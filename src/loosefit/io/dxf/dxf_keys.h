#pragma once
#include <string>

namespace loosefit::io {

/// The name that ASTM D6673 gives to a key of a text ("Size: 40", "Größe: 40", "TALLA: 40"), in
/// small letters: "size", "sample size", "piece name", "style name", "units", "fabric"; any other
/// key in small letters as it is. Keys are known in English, German, French, Spanish, Italian,
/// Portuguese and Dutch.
std::string dxf_key(const std::string& written);

}  // namespace loosefit::io
