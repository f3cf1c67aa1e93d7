# Makes the page that shows view files: one HTML file in two parts, before and behind the data, as
# C++. Sets view_page_source and view_page_includes.
#
# The page allows no scripts and styles but its own, by their hashes (content security policy).
set(view_page_folder "${CMAKE_CURRENT_LIST_DIR}/Page")
set(view_page_scripts container.js decode.js lookup.js shade.js rays.js histogram.js picture.js
  controls.js main.js)
set(view_page_includes "${CMAKE_CURRENT_BINARY_DIR}/ViewPage")
set(view_page_source "${view_page_includes}/ViewPageParts.cxx")

# SHA-256 of a text, in Base64.
function (view_page_hash text result)
  set(digits "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  string(SHA256 hex "${text}")
  set(encoded "")
  foreach (group RANGE 0 60 6)
    string(SUBSTRING "${hex}00" ${group} 6 six)
    math(EXPR number "0x${six}")
    foreach (shift 18 12 6 0)
      math(EXPR digit "(${number} >> ${shift}) & 63")
      string(SUBSTRING "${digits}" ${digit} 1 character)
      string(APPEND encoded "${character}")
    endforeach ()
  endforeach ()
  # 32 bytes take 43 digits.
  string(SUBSTRING "${encoded}" 0 43 encoded)
  set(${result} "${encoded}=" PARENT_SCOPE)
endfunction ()

# A C++ function that returns a text. Compilers limit the length of a literal.
function (view_page_function name text result)
  set(code "std::string ${name}()\n{\n  std::string text;\n")
  string(LENGTH "${text}" length)
  set(at 0)
  while (at LESS length)
    string(SUBSTRING "${text}" ${at} 12000 piece)
    string(APPEND code "  text += R\"PAGE(${piece})PAGE\";\n")
    math(EXPR at "${at} + 12000")
  endwhile ()
  set(${result} "${code}  return text;\n}\n" PARENT_SCOPE)
endfunction ()

file(READ "${view_page_folder}/view.html" view_page_html)
file(READ "${view_page_folder}/view.css" view_page_style)
set(view_page_script "\"use strict\";\n(() => {\n")
foreach (part IN LISTS view_page_scripts)
  file(READ "${view_page_folder}/${part}" view_page_part)
  string(APPEND view_page_script "${view_page_part}")
endforeach ()
string(APPEND view_page_script "})();\n")
view_page_hash("${view_page_script}" view_page_script_hash)
view_page_hash("${view_page_style}" view_page_style_hash)
string(REPLACE "@SCRIPT_HASH@" "${view_page_script_hash}" view_page_html "${view_page_html}")
string(REPLACE "@STYLE_HASH@" "${view_page_style_hash}" view_page_html "${view_page_html}")
string(REPLACE "@STYLE@" "${view_page_style}" view_page_html "${view_page_html}")
string(REPLACE "@SCRIPT@" "${view_page_script}" view_page_html "${view_page_html}")
string(FIND "${view_page_html}" "@DATA@" view_page_split)
string(SUBSTRING "${view_page_html}" 0 ${view_page_split} view_page_begin)
math(EXPR view_page_split "${view_page_split} + 6")
string(SUBSTRING "${view_page_html}" ${view_page_split} -1 view_page_end)
view_page_function(ViewPageBegin "${view_page_begin}" view_page_begin)
view_page_function(ViewPageEnd "${view_page_end}" view_page_end)
file(CONFIGURE OUTPUT "${view_page_source}" @ONLY CONTENT
  "// Made by Page.cmake from the files in Page.\n#include \"ViewPageParts.h\"\n\nnamespace TemporalCoherence\n{\n\n@view_page_begin@\n@view_page_end@\n}\n")
file(CONFIGURE OUTPUT "${view_page_includes}/ViewPageParts.h" @ONLY CONTENT
  "// Made by Page.cmake.\n#ifndef TemporalCoherence_ViewPageParts_h\n#define TemporalCoherence_ViewPageParts_h\n\n#include <string>\n\nnamespace TemporalCoherence\n{\n\n/// The page before the data. @TITLE@, @CAPTION@, @CITATION@ and @POSTER@ are to be
/// replaced.\nstd::string ViewPageBegin();\n/// The page behind the data.\nstd::string ViewPageEnd();\n\n}\n\n#endif\n")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  "${view_page_folder}/view.html" "${view_page_folder}/view.css")
foreach (part IN LISTS view_page_scripts)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${view_page_folder}/${part}")
endforeach ()
