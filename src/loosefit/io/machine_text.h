#pragma once
#include <string>

namespace loosefit::io {

/// The language of a machine that a text is written in: "a plot file (HPGL)", "a machine program
/// (G-code)", "a photoplot (Gerber RS-274X)", "a cutter file (Gerber, ISO 6983)";
/// empty: none of these. Looks at the first 4000 characters. Sources: Hewlett-Packard, The HP-GL/2
/// and HP RTL Reference Guide (two letters, numbers, a semicolon); ISO 6983 (words of a letter and
/// a number); Ucamco, The Gerber Layer Format Specification (FS and MO between percent signs).
std::string machine_language(const std::string& text);

}  // namespace loosefit::io
