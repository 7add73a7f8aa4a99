// The assembler embeds the web files in the program unchanged.
#include "reports/web_bundle.h"

#define EMBED(name, file)                                         \
  asm(".section .rodata\n"                                        \
      ".global cylon_web_" #name                                  \
      "\n"                                                        \
      ".global cylon_web_" #name                                  \
      "_end\n"                                                    \
      "cylon_web_" #name ": .incbin \"" CYLON_WEB_BUNDLE "/" file \
      "\"\n"                                                      \
      "cylon_web_" #name                                          \
      "_end: .byte 0\n"                                           \
      ".previous\n");                                             \
  extern "C" const char cylon_web_##name[], cylon_web_##name##_end[]

EMBED(script, "cylon.js");
EMBED(style, "cylon.css");
EMBED(hash, "csp.txt");

namespace cylon::web {

std::string_view script() { return {cylon_web_script, cylon_web_script_end}; }
std::string_view style() { return {cylon_web_style, cylon_web_style_end}; }
std::string_view script_hash() { return {cylon_web_hash, cylon_web_hash_end}; }

}  // namespace cylon::web
