#pragma once
#include <string>

#include "loosefit/io/svg/svg_document.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {

/// The label, else the id unless a program gave it by itself ("path3", "rect12-5", "layer1").
std::string own_name(const std::string& label, const std::string& id);

/// Own names of a shape and of all groups round it, with a blank between them.
std::string all_labels(const SvgDocument& document, const SvgShape& shape);

/// A line that is called something by its own name, as messages name it: "neck hole" at line 12.
std::string called_line(const SvgShape& shape);

/// A text without white space round it, and one blank between its words.
std::string trimmed_words(const std::string& text);

/// Small letters and digits of a text, in words with a blank before and after each.
std::string in_words(const std::string& text);

/// Whether the words of one stand in the other, in their order.
bool has_words(const std::string& text, const std::string& wanted);

/// Whether a word of `other` that is not in `own` stands in the text: "seam S" where an outline is
/// called "front S" and another one "front M".
bool has_words_of_other(const std::string& text, const std::string& other, const std::string& own);

/// A line of the file as messages name it: "front" in size M; the one at line 12.
std::string described(const SvgDocument& document, const SvgShape& shape);

/// What the label, id and class of a shape say.
pattern::PieceWords words_of_shape(const SvgShape& shape);

/// What the group says in which a shape stands.
pattern::PieceWords words_of_group(const SvgDocument& document, const SvgShape& shape);

/// Whether a line is called a hole: by its own label, id or class, else by the group round it.
bool is_called_hole(const SvgDocument& document, const SvgShape& shape);

/// The innermost group round a shape; −1.
int innermost_group(const SvgShape& shape);

}  // namespace loosefit::io
