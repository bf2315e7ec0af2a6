#include "loosefit/io/dxf/dxf_keys.h"

#include <cctype>
#include <string_view>

namespace loosefit::io {
namespace {

struct Key {
  const char* standard;
  std::string_view written;  ///< with a stroke behind each
};

constexpr Key kKeys[] = {
    {"size", "größe|grösse|groesse|gr.|taille|talla|taglia|tamanho|tam.|maat|"},
    {"sample size",
     "samplesize|base size|basis size|basic size|basisgröße|basisgrösse|basisgroesse|grundgröße|"
     "grundgrösse|grundgroesse|mustergröße|taille de base|taille base|talla base|talla de base|"
     "taglia base|taglia campione|tamanho base|basismaat|"},
    {"piece name",
     "piecename|piece|teil|teilname|teilename|schnittteil|pièce|nom de pièce|nom de la pièce|"
     "nom pièce|pieza|nombre de pieza|nombre de la pieza|pezzo|nome pezzo|nome del pezzo|peça|"
     "nome da peça|patroondeel|"},
    {"style name",
     "stylename|style|modell|modellname|modèle|nom du modèle|modelo|nombre del modelo|modello|"
     "nome modello|nome del modello|"},
    {"units",
     "unit|einheit|einheiten|maßeinheit|masseinheit|unité|unités|unidad|unidades|unità|unidade|"
     "eenheid|eenheden|"},
    {"fabric", "stoff|tissu|tejido|tela|tessuto|tecido|stof|"},
};

/// Small letters, those with accents of Latin 1 too.
std::string lower(const std::string& text) {
  std::string small;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = text[i];
    const unsigned char before = i > 0 ? text[i - 1] : 0;
    // U+00C0 to U+00DE and their small letters 32 above; U+00D7 is a sign.
    const bool accented = before == 0xc3 && c >= 0x80 && c <= 0x9e && c != 0x97;
    small += static_cast<char>(accented ? c + 0x20 : c < 0x80 ? std::tolower(c) : c);
  }
  return small;
}

}  // namespace

std::string dxf_key(const std::string& written) {
  const std::string key = lower(written);
  for (const auto& [standard, all] : kKeys)
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = all.find('|', at);
      if (all.substr(at, end - at) == key) return standard;
      at = end + 1;
    }
  return key;
}

}  // namespace loosefit::io
