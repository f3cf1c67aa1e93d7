# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The examples build against an installation and nothing else, run, and make pictures that show
# something.
#
# Called by ctest (see Examples.cmake) with
#   BUILD CONFIGURATION    the build to install
#   EXAMPLES SCRATCH       directories: the examples' sources; where all this happens
#   CHECK_PICTURE          a program that fails for pictures that show nothing
#   GENERATOR CXX_COMPILER C_COMPILER CXX_FLAGS VTK_DIR
cmake_minimum_required(VERSION 3.16)

set(prefix "${SCRATCH}/install")
set(pictures "${SCRATCH}/pictures")

# Runs a command that has to succeed.
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "Failed (${result}): ${ARGN}\n${output}")
  endif ()
endfunction ()

# Only the prefix is cleared: unchanged examples are not compiled again.
file(REMOVE_RECURSE "${prefix}" "${pictures}")
file(MAKE_DIRECTORY "${pictures}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIGURATION}" --prefix "${prefix}")

set(examples DropIn OrbitAndSweep Command)
if (HAS_EXPLORER)
  list(APPEND examples Explorer)
endif ()
foreach (example IN LISTS examples)
  set(directory "${SCRATCH}/${example}")
  run("${CMAKE_COMMAND}" -S "${EXAMPLES}/${example}" -B "${directory}" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIGURATION}"
    # Headers take longer to compile than the files themselves.
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
    "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DVTK_DIR=${VTK_DIR}"
    "-DEXPLORER_TESTS=ON")
  # Not the build tree's package, nor one that the machine has.
  file(STRINGS "${directory}/CMakeCache.txt" found REGEX "^vtkTemporalCoherence_DIR:")
  string(FIND "${found}" "=${prefix}/" position)
  if (position EQUAL -1)
    message(FATAL_ERROR "${example} was not built against ${prefix} but: ${found}")
  endif ()
  run("${CMAKE_COMMAND}" --build "${directory}" --config "${CONFIGURATION}")
  message(STATUS "${example}: built against ${prefix}")
endforeach ()

# No display: the examples must not want one.
unset(ENV{DISPLAY})
unset(ENV{WAYLAND_DISPLAY})
unset(ENV{QT_QPA_PLATFORM})
find_program(drop_in DropIn PATHS "${SCRATCH}/DropIn" PATH_SUFFIXES "${CONFIGURATION}"
  NO_DEFAULT_PATH REQUIRED)
if (HAS_EXPLORER)
  find_program(explorer Explorer PATHS "${SCRATCH}/Explorer" PATH_SUFFIXES "${CONFIGURATION}"
    NO_DEFAULT_PATH REQUIRED)
  find_program(scripted ScriptedExplorer PATHS "${SCRATCH}/Explorer"
    PATH_SUFFIXES "${CONFIGURATION}" NO_DEFAULT_PATH REQUIRED)
endif ()
find_program(orbit_and_sweep OrbitAndSweep PATHS "${SCRATCH}/OrbitAndSweep"
  PATH_SUFFIXES "${CONFIGURATION}" NO_DEFAULT_PATH REQUIRED)

execute_process(COMMAND "${drop_in}" WORKING_DIRECTORY "${pictures}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "DropIn failed (${result}):\n${output}")
endif ()

execute_process(
  COMMAND "${orbit_and_sweep}" --spheres 64 --isovalue 100 --quick --output "${pictures}/tour"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
message(STATUS "OrbitAndSweep said:\n${output}")
if (NOT result EQUAL 0 OR NOT output MATCHES "orbit +[A-Za-z]+ +4 " OR
  NOT output MATCHES "colour +Reshade " OR NOT output MATCHES "repeat +Redisplay " OR
  NOT output MATCHES "vtkFlyingEdges3D")
  message(FATAL_ERROR "OrbitAndSweep failed (${result}), or its table lacks a row")
endif ()

file(GLOB tour "${pictures}/tour/*.png")
list(LENGTH tour count)
# 4 of the orbit, 4 thresholds, 2 colours and the contact sheet.
if (NOT count EQUAL 11)
  message(FATAL_ERROR "OrbitAndSweep wrote ${count} pictures instead of 11: ${tour}")
endif ()
run("${CHECK_PICTURE}" "${pictures}/dropin.png" ${tour})

# One picture a command, each of another kind.
find_program(command temporal-coherence PATHS "${SCRATCH}/Command" PATH_SUFFIXES "${CONFIGURATION}"
  NO_DEFAULT_PATH REQUIRED)
set(command_pictures "")
function (draw_by_command name)
  run("${command}" --spheres 48 --size 96x64 -o "${pictures}/${name}.png" ${ARGN})
  list(APPEND command_pictures "${pictures}/${name}.png")
  set(command_pictures "${command_pictures}" PARENT_SCOPE)
endfunction ()
draw_by_command(plain)
draw_by_command(two --iso 60,110 --opacity 0.3,1 --color "tan,#40c080")
draw_by_command(preset --preset mr --shift 5)
draw_by_command(largest --maximum --window 80 --level 60 --background white)
draw_by_command(smallest --minimum)
draw_by_command(clipped --iso 100 --clip -x --threshold --material glossy --light side)
draw_by_command(turned --from -x --azimuth 20 --elevation 10 --zoom 1.2 --parallel --samples 4)
draw_by_command(light --occlusion --shadows --light rim)
run("${CHECK_PICTURE}" ${command_pictures})
list(REMOVE_DUPLICATES command_pictures)
foreach (name IN LISTS command_pictures)
  file(MD5 "${name}" digest)
  list(APPEND digests "${digest}")
endforeach ()
list(LENGTH digests count)
list(REMOVE_DUPLICATES digests)
list(LENGTH digests different)
if (NOT count EQUAL different)
  message(FATAL_ERROR "Two commands of different options draw the same picture")
endif ()
run("${command}" --spheres 32 --size 48 --film turn --frames 3 -o "${pictures}/turn")
file(GLOB turn "${pictures}/turn/*.png")
list(LENGTH turn count)
if (NOT count EQUAL 3)
  message(FATAL_ERROR "A film of 3 frames has ${count} pictures")
endif ()
run("${CHECK_PICTURE}" ${turn})

# A view for every isovalue, as each kind of file.
run("${command}" --spheres 32 --iso 100 --size 64 --share "${pictures}/view.html" --title "A <b> & \"c\""
  --range 60,140 --units HU)
file(READ "${pictures}/view.html" page)
foreach (text IN ITEMS "<title>A &lt;b&gt; &amp; &quot;c&quot;</title>" "id=\"view-file\">VENWSUVX")
  string(FIND "${page}" "${text}" position)
  if (position EQUAL -1)
    message(FATAL_ERROR "The page ${pictures}/view.html does not hold ${text}")
  endif ()
endforeach ()
run("${command}" --spheres 32 --size 64x48 --share "${pictures}/view.tcview" --views 3 --tolerance 0.5)
file(READ "${pictures}/view.tcview" magic LIMIT 6)
if (NOT magic MATCHES "^TCVIEW")
  message(FATAL_ERROR "${pictures}/view.tcview begins with ${magic}")
endif ()
file(REMOVE_RECURSE "${pictures}/view.cdb")
run("${command}" --spheres 32 --size 48 --share "${pictures}/view.cdb")
file(GLOB images "${pictures}/view.cdb/*.png")
run("${CHECK_PICTURE}" ${images})

# Samples that are read as they are needed give the same pictures and shared views. Letters are samples, too.
set(large "${pictures}/large")
file(MAKE_DIRECTORY "${large}/volume.zarr")
set(samples "")
foreach (plane IN ITEMS ABCDDCBA BCDEEDCB CDFGGFDC DEGHHGED DEGHHGED CDFGGFDC BCDEEDCB ABCDDCBA)
  foreach (row IN ITEMS AAAAAAAA "${plane}" "${plane}" KLMNNMLK KLMNNMLK "${plane}" "${plane}" AAAAAAAA)
    string(APPEND samples "${row}")
  endforeach ()
endforeach ()
file(WRITE "${large}/volume.raw" "${samples}")
file(WRITE "${large}/volume.mhd" "ObjectType = Image
NDims = 3
DimSize = 8 8 8
ElementSpacing = 1 1 1
ElementType = MET_UCHAR
ElementDataFile = volume.raw
")
file(WRITE "${large}/volume.zarr/.zarray" "{\"zarr_format\": 2, \"shape\": [8, 8, 8],
\"chunks\": [8, 8, 8], \"dtype\": \"|u1\", \"compressor\": null, \"fill_value\": 0,
\"order\": \"C\", \"filters\": null}")
file(WRITE "${large}/volume.zarr/0.0.0" "${samples}")
foreach (way IN ITEMS volume.mhd "volume.mhd;--large"
    "volume.raw;--raw;8,8,8,uchar;--large" volume.zarr)
  list(GET way 0 volume)
  list(REMOVE_AT way 0)
  run("${command}" "${large}/${volume}" ${way} --iso 70 --size 96 -o "${large}/picture.png")
  run("${CHECK_PICTURE}" "${large}/picture.png")
  file(MD5 "${large}/picture.png" digest)
  if (DEFINED digest_in_memory AND NOT digest STREQUAL digest_in_memory)
    message(FATAL_ERROR "${volume} ${way}: another picture than of samples in memory")
  endif ()
  set(digest_in_memory "${digest}")
  run("${command}" "${large}/${volume}" ${way} --iso 70 --size 96 --share "${large}/view.tcview")
  file(MD5 "${large}/view.tcview" digest)
  if (DEFINED view_in_memory AND NOT digest STREQUAL view_in_memory)
    message(FATAL_ERROR "${volume} ${way}: another view than of samples in memory")
  endif ()
  set(view_in_memory "${digest}")
endforeach ()

# Wrong use: exit status 1, and one line of a size to read that holds the given words, and nothing
# that a terminal would obey.
string(ASCII 27 escape)
function (expect_refusal_of command words)
  execute_process(COMMAND ${command} ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE complaint)
  string(REGEX MATCHALL "\n" lines "${complaint}")
  list(LENGTH lines count)
  string(FIND "${complaint}" "${words}" position)
  string(LENGTH "${complaint}" length)
  string(FIND "${complaint}" "${escape}" control)
  if (NOT result EQUAL 1 OR NOT count EQUAL 1 OR position EQUAL -1 OR length GREATER 1500 OR
    NOT control EQUAL -1)
    message(FATAL_ERROR
      "${command} ${ARGN}: expected exit status 1 and one line with '${words}', got ${result} "
      "and:\n${complaint}")
  endif ()
endfunction ()
function (expect_refusal_of_explorer words)
  if (HAS_EXPLORER)
    expect_refusal_of("${explorer}" "${words}" ${ARGN})
  endif ()
endfunction ()
foreach (mistake IN ITEMS "takes a number|--iso;60,nan" "outside the values|--iso;900"
    "leave out --iso|--iso;100;--preset;mr" "more opacities|--opacity;0.3,0.4" "ends with .png|-o;x.jpg"
    "square number|--samples;5" "one of surfaces|--draw;nothing" "takes colours|--color;blurple"
    "give --clip, too|--cut;colours" "belong together|--window;3" "needs a display|--axes"
    "is neither|--film;turn;-o;x.txt" "no directory|-o;/nowhere/at/all.png" "from 0 to 1|--opacity;2"
    "commas between|--iso;60,,70" "an axis and a place|--clip;w=3" "name one by --preset|--shift;3"
    "given twice|--iso;60,60" "those of a film|--frames;5" "--shift takes|--preset;mr;--shift;1e9"
    "must lie within|--maximum;--window;9;--level;1e9" "no array 'Temp' to colour by|--color-by;Temp"
    "none are drawn|--preset;mr;--color-by;Temp" "give one of them|--color;tan;--color-by;Temp"
    "give --share|--title;A" "leave out --output|--share;x.html;-o;x.png" "lowest and the highest|--range;9,3"
    "by plain light|--share;x.html;--shadows" "by plain light|--share;x.html;--threshold"
    "ends with .html|--share;x.jpg" "from 0.02 to 10|--share;x.html;--tolerance;0"
    "set another range|--share;x.html;--range;900,950" "is blended|--share;x.html;--preset;mr"
    "no directory|--share;/nowhere/at/all.html")
  string(REGEX MATCH "^[^|]*" words "${mistake}")
  string(REGEX REPLACE "^[^|]*[|]" "" arguments "${mistake}")
  expect_refusal_of("${command};--spheres;16" "${words}" ${arguments})
endforeach ()
string(CONCAT tetrahedron "# vtk DataFile Version 3.0\none cell\nASCII\nDATASET UNSTRUCTURED_GRID\n"
  "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
  "POINT_DATA 4\nSCALARS s float\nLOOKUP_TABLE default\n0 1 2 3\n"
  "SCALARS t float\nLOOKUP_TABLE default\n0 2 1 5\nVECTORS v float\n0 1 2 3 4 5 6 7 9 1 1 2\n")
file(WRITE "${SCRATCH}/tetrahedron.vtk" "${tetrahedron}")
expect_refusal_of("${command}" "is a mesh" "${SCRATCH}/tetrahedron.vtk" --preset mr)
expect_refusal_of("${command}" "resample other data" "${SCRATCH}/tetrahedron.vtk" --share x.html)
# Colours of another array, and of a component.
expect_refusal_of("${command}" "those it has: s, t, v" "${SCRATCH}/tetrahedron.vtk" --color-by w)
expect_refusal_of("${command}" "from 1 to 3" "${SCRATCH}/tetrahedron.vtk" --color-by v:4)
set(digests "")
foreach (colors IN ITEMS s t v v:2 "t;--color-map;viridis")
  run("${command}" "${SCRATCH}/tetrahedron.vtk" --size 48 -o "${pictures}/colors.png"
    --color-by ${colors})
  run("${CHECK_PICTURE}" "${pictures}/colors.png")
  file(MD5 "${pictures}/colors.png" digest)
  list(APPEND digests "${digest}")
endforeach ()
list(REMOVE_DUPLICATES digests)
list(LENGTH digests different)
if (NOT different EQUAL 5)
  message(FATAL_ERROR "Of five pictures coloured by arrays, ${different} differ")
endif ()
function (expect_refusal words)
  expect_refusal_of("${orbit_and_sweep};--quick;--output;${pictures}/refused" "${words}" ${ARGN})
endfunction ()

file(WRITE "${SCRATCH}/short.raw" "12345")
file(WRITE "${SCRATCH}/broken.vti" "This is no XML.")
file(WRITE "${SCRATCH}/broken.vtk" "This is no legacy file.")
file(WRITE "${SCRATCH}/broken.mhd" "ObjectType = Image")
file(WRITE "${SCRATCH}/notes.txt" "This is no volume.")
file(MAKE_DIRECTORY "${SCRATCH}/empty")
expect_refusal("There is no file" "${SCRATCH}/missing.vti")
expect_refusal("could not be read" "${SCRATCH}/broken.vti")
expect_refusal("could not be read" "${SCRATCH}/broken.vtk")
expect_refusal("could not be read" "${SCRATCH}/broken.mhd")
expect_refusal("suffix" "${SCRATCH}/notes.txt")
expect_refusal("DICOM" "${SCRATCH}/empty")
expect_refusal("--raw tells of 8" "${SCRATCH}/short.raw" --raw 2,2,2,uchar)
expect_refusal("--raw takes" "${SCRATCH}/short.raw" --raw 2,2,uchar)
expect_refusal("name that file, too" --raw 2,2,2,uchar)
expect_refusal("isovalue is a number" "${SCRATCH}/short.raw" many)
expect_refusal("outside the values of 'four generated spheres'" --spheres 16 --isovalue 900)
expect_refusal("--size takes" --spheres 16 --size 0x100)
expect_refusal("--size takes" --spheres 16 --size big)
expect_refusal("needs a value" --spheres 16 --size)
expect_refusal("no option" --spheres 16 --sise 100)
expect_refusal("cannot be made or written" --spheres 16 --output "${SCRATCH}/notes.txt/pictures")
expect_refusal_of_explorer("needs a display" --spheres 16)
expect_refusal_of_explorer("There is no session" --session "${SCRATCH}/missing.session")
expect_refusal_of_explorer("no session of this program" --session "${SCRATCH}/notes.txt")
if (HAS_EXPLORER)
  expect_refusal_of("${scripted}" "--measure-drag takes" --measure-drag none)
endif ()
# What is cited is shown, not obeyed.
set(obeyed "${escape}[2J${escape}c")
string(REPEAT "long" 10000 long)
file(WRITE "${SCRATCH}/obeyed.session"
  "# vtkTemporalCoherence Explorer session 1\n${obeyed} = 1\n")
file(WRITE "${SCRATCH}/long.session" "# vtkTemporalCoherence Explorer session 1\n${long} = 1\n")
expect_refusal("There is no file '${SCRATCH}/a\\x1b[2J\\x1bc.vti'" "${SCRATCH}/a${obeyed}.vti")
expect_refusal("not '\\x1b[2J\\x1bc'" --spheres 16 --size "${obeyed}")
expect_refusal("There is no option '--\\x1b" "--${obeyed}")
expect_refusal("isovalue is a number" "${SCRATCH}/short.raw" "${long}")
expect_refusal_of_explorer("understood: '\\x1b[2J" --session "${SCRATCH}/obeyed.session")
expect_refusal_of_explorer(" ... " --session "${SCRATCH}/long.session")
message(STATUS "Wrong use is refused in one sentence")
