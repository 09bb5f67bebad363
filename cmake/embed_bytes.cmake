# Writes a C++ file with the bytes of every file of a folder, by the assembler's .incbin:
# cmake -DFOLDER=... -DFUNCTION=... -DITEM=... -DOUTPUT=... -DHEADER=... -DNAMESPACE=... [-DEXCLUDE=REGEX]
#   -P embed_bytes.cmake
# An item is {path, bytes}, or {path, type, bytes} where FOLDER holds a list of types (types.txt: "path<tab>type").

set(types "")
if(EXISTS "${FOLDER}/types.txt")
  file(STRINGS "${FOLDER}/types.txt" types)
endif()
file(GLOB_RECURSE names RELATIVE ${FOLDER} ${FOLDER}/*)
list(REMOVE_ITEM names types.txt)
if(EXCLUDE)
  list(FILTER names EXCLUDE REGEX "${EXCLUDE}")
endif()
list(SORT names)

set(externs "")
set(items "")
set(k 0)
foreach(name IN LISTS names)
  set(symbol "talus_${FUNCTION}_${k}")
  math(EXPR k "${k} + 1")
  file(SHA256 "${FOLDER}/${name}" digest)  # so that a compiler cache sees that the file has changed
  string(APPEND externs "// ${digest}\nextern const char ${symbol}[], ${symbol}_end[];\n"
    "asm(\".section .rodata\\n.global ${symbol}\\n${symbol}:\\n.incbin \\\"${FOLDER}/${name}\\\"\\n\"\n"
    "    \".global ${symbol}_end\\n${symbol}_end:\\n.byte 0\\n.previous\\n\");\n")
  set(type "")
  foreach(line IN LISTS types)
    if(line MATCHES "^([^\t]*)\t(.*)$" AND CMAKE_MATCH_1 STREQUAL name)
      set(type "\"${CMAKE_MATCH_2}\", ")
    endif()
  endforeach()
  string(APPEND items
    "      {\"${name}\", ${type}{${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
endforeach()

file(WRITE "${OUTPUT}" "// Made by cmake/embed_bytes.cmake; do not edit.
#include \"${HEADER}\"

#include <cstddef>

extern \"C\" {
${externs}}

namespace ${NAMESPACE} {

const std::vector<${ITEM}>& ${FUNCTION}() {
  static const std::vector<${ITEM}> items{
${items}  };
  return items;
}

}  // namespace ${NAMESPACE}
")
