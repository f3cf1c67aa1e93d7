# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The examples build against an installation and nothing else, run, and make pictures that show
# something. The command draws what its options say, and refuses each mistake in one sentence.
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
find_program(command temporal-coherence PATHS "${SCRATCH}/Command"
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

# One line on the volume and one on the picture, which shows something; what else is said holds the
# given words.
file(MAKE_DIRECTORY "${pictures}/command")
function (expect_picture name words)
  execute_process(COMMAND "${command}" --spheres 64 --size 160x120 -o "${pictures}/command/${name}" ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE complaint)
  string(FIND "${said}" "${words}" position)
  string(REGEX MATCH "(Picture|Film): [^\n]*, 160 x 120 pixels, [0-9.]+ [kM]?(B|bytes), made in [0-9.e-]+ s\n" made "${said}")
  if (result OR complaint OR NOT made OR position EQUAL -1)
    message(FATAL_ERROR
      "temporal-coherence ${ARGN} (${result}): expected a picture and '${words}', got\n${said}${complaint}")
  endif ()
endfunction ()
expect_picture(chosen.png "chosen from the histogram")
expect_picture(several.png "surfaces at 80, 180" --iso 80 --iso 180 --opacity 0.4,1 --color "tomato,#3080ff")
expect_picture(solid.png "surface at 80" --isovalue 80 --threshold --clip +x=50% --background transparent
  --azimuth 30 --elevation 40 --zoom 1.2 --parallel --from +x --up +y --shadows --samples 2)
expect_picture(depth.png "surface at 80" --iso 80 --occlusion --background white)
expect_picture(mr.png "preset" --preset mr --shift 10)
expect_picture(ct.png "no Hounsfield units" --preset "ct bone")
expect_picture(maximum.png "black at 50, white at 150" --maximum --window 100 --level 100)
expect_picture(minimum.png "minimum" --minimum --background white)
expect_picture(average.png "average" --average)
expect_picture(turn "Film: " --film turn --frames 3)
expect_picture(sweep "from 60 to 200" --film sweep --iso 60,200 --frames 3)
file(GLOB made "${pictures}/command/*.png" "${pictures}/command/*/frame-*.png")
list(LENGTH made count)
# 9 pictures and 2 films of 3.
if (NOT count EQUAL 15)
  message(FATAL_ERROR "temporal-coherence wrote ${count} pictures instead of 15: ${made}")
endif ()
run("${CHECK_PICTURE}" ${made})
expect_picture(empty.png "Nothing of" --clip +x=-5)
execute_process(COMMAND "${command}" --spheres 32 --size 64 --film turn --frames 2
  WORKING_DIRECTORY "${pictures}" RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if (result OR NOT (EXISTS "${pictures}/spheres.ogv" OR EXISTS "${pictures}/spheres-film/frame-0002.png"))
  message(FATAL_ERROR "temporal-coherence made no film with a name of its own (${result}):\n${said}")
endif ()
run("${CMAKE_COMMAND}" --install "${SCRATCH}/Command" --config "${CONFIGURATION}" --prefix "${prefix}")
foreach (file IN ITEMS bin/temporal-coherence share/man/man1/temporal-coherence.1)
  if (NOT EXISTS "${prefix}/${file}")
    message(FATAL_ERROR "temporal-coherence was installed without ${file}")
  endif ()
endforeach ()
message(STATUS "temporal-coherence draws surfaces, blended volumes, projections and films")

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
function (expect_refusal words)
  expect_refusal_of("${orbit_and_sweep};--quick;--output;${pictures}/refused" "${words}" ${ARGN})
endfunction ()
function (expect_refusal_of_command words)
  expect_refusal_of("${command};--spheres;16" "${words}" ${ARGN})
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
expect_refusal_of("${command}" "Name the file of a volume")
expect_refusal_of("${command}" "There is no file" "${SCRATCH}/missing.vti")
expect_refusal_of_command("--iso takes isovalues" --iso nan)
expect_refusal_of_command("--iso takes isovalues" --iso 60,)
expect_refusal_of_command("needs a value" --iso)
expect_refusal_of_command("given twice" --iso 60 --iso 60)
expect_refusal_of_command("outside the values" --iso 60,900)
expect_refusal_of_command("--opacity has 3 opacities" --iso 60,80 --opacity 1,0.5,0.2)
expect_refusal_of_command("--opacity takes" --opacity 0)
expect_refusal_of_command("--color takes" --color bluish)
expect_refusal_of_command("--color takes" --color "#12345")
expect_refusal_of_command("--preset takes one of" --preset bone)
expect_refusal_of_command("--iso is for surfaces" --iso 60 --preset mr)
expect_refusal_of_command("A picture has one of" --maximum --minimum)
expect_refusal_of_command("nothing would be drawn" --preset mr --shift 10000)
expect_refusal_of_command("--shift moves a preset" --shift 5)
expect_refusal_of_command("give --maximum" --window 5)
expect_refusal_of_command("--window takes a number above 0" --maximum --window -5)
expect_refusal_of_command("--size takes" --size -5x5)
expect_refusal_of_command("--samples takes" --samples 0)
expect_refusal_of_command("too many rays" --samples 16 --size 2000)
expect_refusal_of_command("--elevation takes" --elevation 90)
expect_refusal_of_command("--zoom takes" --zoom 0)
expect_refusal_of_command("--clip takes" --clip x)
expect_refusal_of_command("--film takes" --film jump)
expect_refusal_of_command("give --film" --frames 5)
expect_refusal_of_command("give --iso FROM,TO" --film sweep --iso 60)
expect_refusal_of_command("not as '.jpg'" -o "${pictures}/refused.jpg")
expect_refusal_of_command("not as '.avi'" --film turn -o "${pictures}/refused.avi")
expect_refusal_of_command("is a directory" -o "${pictures}")
expect_refusal_of_command("cannot be written" -o "${SCRATCH}/notes.txt/picture.png")
expect_refusal_of_command("There is no option" --colour red)
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
