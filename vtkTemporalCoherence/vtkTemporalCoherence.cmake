# The module's sources, for both ways to build it (inside VTK, stand-alone).
set(module_directory "${CMAKE_CURRENT_LIST_DIR}")
find_package(glm REQUIRED)
find_package(hwy REQUIRED)
include("${CMAKE_CURRENT_LIST_DIR}/VolumeFormats.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/ViewFiles.cmake")
if (NOT TEMPORAL_COHERENCE_HAS_ZARR)
  message(STATUS "Zarr volumes cannot be read: nlohmann_json, zlib, c-blosc or zstd is missing.")
endif ()
if (NOT TEMPORAL_COHERENCE_HAS_HDF5)
  message(STATUS "HDF5 volumes cannot be read: libhdf5 or zlib is missing.")
endif ()

set(engine_files
  Bricks/BrickCache
  Bricks/SampleUse
  Scene/FieldShape
  Scene/FrameKey
  Scene/FramePlanes
  Scene/HiddenCells
  Scene/LabelIndex
  Scene/LabelSets
  Scene/RayBatch
  Scene/Region
  Scene/ValueTable
  Scene/View
  Acceleration/ActiveCells
  Acceleration/FieldFingerprint
  Acceleration/FieldStructures
  Acceleration/FiniteRange
  Acceleration/KernelsPyramid
  Acceleration/RangeScan
  Acceleration/RareValues
  Acceleration/SampleComparer
  Acceleration/SurfaceHistogram
  Acceleration/TileBounds
  Acceleration/ValueRangePyramid
  Lattice/BeamChoice
  Lattice/KernelsBeam
  Lattice/KernelsBeamSetUp
  Lattice/KernelsBlocked
  Lattice/KernelsCellValues
  Lattice/KernelsCorners
  Lattice/KernelsCrossing
  Lattice/KernelsLayerBeam
  Lattice/KernelsMetCells
  Lattice/KernelsRange
  Lattice/KernelsRays
  Lattice/KernelsWalk
  Lattice/LabelTracer
  Lattice/RayPieces
  Lattice/RaySource
  Lattice/RegionClipper
  Lattice/SmoothLabels
  Lattice/SurfaceTracer
  Lattice/UniformTracer
  ImageCache/ImageCache
  ImageCache/ImageQuery
  ImageCache/KernelsImage
  ImageCache/PaperHint
  Shade/CapNormal
  Shade/FieldNormals
  Shade/HitColors
  Shade/HitGathering
  Shade/HitOpacities
  Shade/HitValues
  Shade/KeptHitValues
  Shade/KernelsCells
  Shade/KernelsGradients
  Shade/KernelsRectilinear
  Shade/KernelsShading
  Shade/KnownLayers
  Shade/LabelGradients
  Shade/LatticeValues
  Shade/LayerShader
  Shade/Light/HardShadows
  Shade/Light/KeptShadows
  Shade/Light/LightCache
  Shade/Light/LightDirections
  Shade/Light/LightTracer
  Shade/Light/PatchPlace
  Shade/Light/SurfaceLight
  Shade/LimitedLayers
  Shade/RecoloredLayers
  Shade/RectilinearGradients
  Shade/Shader
  Shade/SurfaceNormal
  Shade/TileCompositor
  Shade/TileShader
  Isomap/BandBuilder
  Isomap/DragRule
  Isomap/FrameBands
  Isomap/Isomap
  Isomap/IsomapBuilder
  Isomap/IsomapLookup
  Isomap/KernelsBandBeam
  Isomap/KnotCollector
  Isomap/KnotImage
  Isomap/Knots
  Isomap/RangeBuild
  Isomap/TileGroups
  Isomap/UniformBandTracer
  Mesh/Cells/CellPoints
  Mesh/Cells/HexahedronRoots
  Mesh/Cells/KernelsCellGradients
  Mesh/Cells/KernelsHexahedra
  Mesh/Cells/KernelsHexahedronSpans
  Mesh/Cells/KernelsKnownTetrahedra
  Mesh/Cells/KernelsTetrahedra
  Mesh/Tree/MeshBoxes
  Mesh/Tree/MeshCheck
  Mesh/Tree/MeshLeaves
  Mesh/Tree/MeshOrder
  Mesh/Tree/MeshRanges
  Mesh/Tree/MeshTree
  Mesh/Tree/RadixSort
  Mesh/Tiles/ActiveLeaves
  Mesh/Tiles/BoxLevels
  Mesh/Tiles/CellCuts
  Mesh/Tiles/CellFolds
  Mesh/Tiles/KernelsBoxes
  Mesh/Tiles/KernelsMeshRays
  Mesh/Tiles/KernelsOutlines
  Mesh/Tiles/KernelsTileGrid
  Mesh/Tiles/PreparedCells
  Mesh/Tiles/PreparedLeaves
  Mesh/Tiles/SeenStrip
  Mesh/Tracing/KernelsDistinct
  Mesh/Tracing/KernelsHitPlaces
  Mesh/Tracing/KernelsSortedTetrahedra
  Mesh/Tracing/MeshBandRays
  Mesh/Tracing/MeshBandTracer
  Mesh/Tracing/MeshCellSearch
  Mesh/Tracing/MeshGradients
  Mesh/Tracing/MeshValues
  Mesh/Tracing/MeshPlaces
  Mesh/Tracing/MeshSolids
  Mesh/Tracing/MeshTracer
  Kinds/FieldKind
  Kinds/LabelKind
  Kinds/MeshKind
  Kinds/RectilinearKind
  Kinds/UniformKind
  Render/Antialias
  Render/BlendRoute
  Render/CapTiles
  Render/EdgePixels
  Render/FewerRaysRoute
  Render/FrameRenderer
  Render/FrameStore
  Render/FrameStructures
  Render/IsomapRoute
  Render/KeepLabelsRoute
  Render/KeptLabels
  Render/GridKey
  Render/LayerLimit
  Render/LineTracer
  Render/RayBudget
  Render/RayGrid
  Render/RayGridFill
  Render/ReusePlan
  Render/Routes
  Render/SampleDistance
  Render/SavedColors
  Render/SurfaceColors
  Render/TileTracer)
set(volume_files
  Volumes/Medium/KernelsEmission
  Volumes/Medium/KernelsVolumeSegments
  Volumes/Medium/TransferTables
  Volumes/Medium/VisibleBands
  Volumes/Beams/CompositeTables
  Volumes/Beams/CompositeTracer
  Volumes/Beams/EmissionArcs
  Volumes/Beams/KernelsCompositeBeam
  Volumes/Samples/ComponentLooks
  Volumes/Samples/ConvergedTracer
  Volumes/Samples/KernelsMedium
  Volumes/Samples/LabelledSegments
  Volumes/Samples/LookTables
  Volumes/Samples/LooksByLabel
  Volumes/Samples/Medium
  Volumes/Samples/MediumParts
  Volumes/Samples/MediumTables
  Volumes/Samples/PhongLight
  Volumes/Samples/SampledTracer
  Volumes/Samples/SegmentSources
  Volumes/Samples/VisibleComponents
  Volumes/Projections/ExtremeLook
  Volumes/Projections/ExtremeSearch
  Volumes/Projections/FieldProbe
  Volumes/Projections/ImageShares
  Volumes/Projections/KernelsExtremes
  Volumes/Projections/KernelsShares
  Volumes/Projections/MetValues
  Volumes/Projections/ProjectionTracer
  Volumes/Projections/ShareTable
  Volumes/Projections/ShareTracer
  Volumes/LatticeBlending)
foreach (files IN ITEMS engine_files volume_files)
  list(TRANSFORM ${files} PREPEND "${module_directory}/Engine/")
  list(TRANSFORM ${files} APPEND ".cxx")
endforeach ()

set(bridge_files
  OutOfCore/BrickArray
  OutOfCore/ChunkBricks
  OutOfCore/ChunkCache
  OutOfCore/CoarseField
  OutOfCore/FileRoom
  OutOfCore/OutOfCoreVolume
  OutOfCore/RangesFile
  OutOfCore/ReadAhead
  OutOfCore/SampleHash
  OutOfCore/StreamedRanges
  OutOfCore/VolumeOfArray
  OutOfCore/VolumeOpener
  Input/BlockCopy
  Input/CellOrigins
  Input/FieldFromImage
  Input/HiddenCellsFromImage
  Input/ImageLattice
  Input/ImageOfGrid
  Input/ImageSource
  Input/ImageValues
  Input/MergedBlocks
  Input/SampleMask
  Input/SamplesOfArray
  Input/ScalarChoice
  Input/SettingCheck
  Input/ToldChanges
  Input/VectorMagnitude
  Input/VolumePlace
  Polyhedra/ClosedSurface
  Polyhedra/ConeDivision
  Polyhedra/FaceCutter
  Polyhedra/UnitCube
  Shapes/BernsteinFunctions
  Shapes/BoundaryParts
  Shapes/CellDivision
  Shapes/CurvedCellReader
  Shapes/CurvedCells
  Shapes/CurvedDivision
  Shapes/CurvedError
  Shapes/CurvedPlan
  Shapes/GivenCells
  Shapes/PolyhedronCells
  Shapes/SharedPoints
  Shapes/StraightCell
  Shapes/SubdividedCells
  Adaptive/AmrBlocks
  Adaptive/AmrLeaves
  Adaptive/AmrMesh
  Grids/CellTypes
  Grids/GridCells
  Grids/GridLeaves
  Grids/EvaluatedCells
  Grids/GridArray
  Grids/GridMesh
  Grids/GridPoints
  Grids/GridShape
  Grids/GridValues
  Grids/MadeFrom
  Grids/MeshDefectText
  Grids/MeshSource
  Window/DepthReader
  Window/LayerDepthClip
  Window/OpenGLWindow
  Window/PassOutput
  Window/PeelPresenter
  Window/PeeledLayers
  Window/PeeledPicture
  Window/PeelingPass
  Window/PicturePresenter
  Window/PixelHit
  Window/PixelRays
  Window/RayEnds
  Window/WindowPicture
  Window/WindowRays
  Request/AppearanceFromVolume
  Request/ArrayLooksFromVolume
  Request/BlendingFromVolume
  Request/DrawnVolume
  Request/EmptyInput
  Request/EmptyPicture
  Request/FieldFromMapper
  Request/GradientOpacityFromVolume
  Request/IsovalueCheck
  Request/LabelLooksFromVolume
  Request/LabelsFromVolume
  Request/LightsFromRenderer
  Request/RegionFromMapper
  Request/RequestFromMapper
  Request/SampledTransfer
  Request/TransferNodes
  Request/ValueDivision
  Request/ViewFromRenderer
  Output/BufferImages
  Output/ImageFromFrame
  Output/PointsFromFrame
  Frames/MapperFrames
  Frames/SelectionPass
  Frames/ViewerStates)
list(TRANSFORM bridge_files PREPEND "${module_directory}/Vtk/")
list(TRANSFORM bridge_files APPEND ".cxx")

# Kinds of vectors that kernels are not compiled for:
# - those whose size is not known when they are compiled, as kernels keep vectors in arrays,
# - those whose time to compile is worth more than what they may gain. SSSE3 serves processors without
#   SSE4 (early Core 2 and Atom, Bobcat). AVX3_DL, AVX3_SPR and AVX10_2 add to AVX3 mostly what works
#   on bytes and half floats; kernels compute mostly with wider numbers. AVX3_ZEN4 stays:
#   it compresses vectors in another way, as the instruction for it is slow there.
set(vectors_left_out HWY_SVE HWY_SVE2 HWY_SVE_256 HWY_SVE2_128 HWY_RVV HWY_SSSE3 HWY_AVX3_DL)
if (hwy_VERSION VERSION_GREATER_EQUAL 1.2)
  list(APPEND vectors_left_out HWY_AVX3_SPR)
endif ()
if (hwy_VERSION VERSION_GREATER_EQUAL 1.3)
  list(APPEND vectors_left_out HWY_AVX10_2)
endif ()
list(JOIN vectors_left_out "|" vectors_left_out)

# The module and the engine's own tests are made of two object libraries: the engine, and its room
# Volumes, which the rest knows by a few headers only.
add_library(TemporalCoherenceVolumes OBJECT ${volume_files})
add_library(TemporalCoherenceEngine OBJECT ${engine_files})
foreach (library IN ITEMS TemporalCoherenceVolumes TemporalCoherenceEngine)
  target_compile_features(${library} PUBLIC cxx_std_17)
  set_target_properties(${library} PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_compile_definitions(${library} PUBLIC "HWY_DISABLED_TARGETS=(${vectors_left_out})")
  target_include_directories(${library} PUBLIC "$<BUILD_INTERFACE:${module_directory}/Engine>")
  target_link_libraries(${library} PUBLIC VTK::CommonCore glm::glm hwy::hwy)
endforeach ()

vtk_module_add_module(VTK::TemporalCoherence
  SOURCES
    "${module_directory}/Choice.cxx"
    "${module_directory}/BlendingTime.cxx"
    "${module_directory}/GpuMapperSettings.cxx"
    "${module_directory}/SettingsFromMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceBrickSource.cxx"
    "${module_directory}/vtkTemporalCoherenceDropInMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceGPUVolumeRayCastMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceObjectFactory.cxx"
    "${module_directory}/vtkTemporalCoherencePaperMapper.cxx"
    "${module_directory}/vtkTemporalCoherencePicker.cxx"
    "${module_directory}/vtkTemporalCoherencePresets.cxx"
    "${module_directory}/vtkTemporalCoherenceRefiner.cxx"
    "${module_directory}/vtkTemporalCoherenceStatistics.cxx"
    "${module_directory}/vtkTemporalCoherenceView.cxx"
    "${module_directory}/vtkTemporalCoherenceViewWriter.cxx"
    "${module_directory}/vtkTemporalCoherenceVolume.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperInternals.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperLastFrame.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperPicking.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperSettings.cxx"
    ${bridge_files}
    ${volume_format_files}
    ${view_file_files}
    $<TARGET_OBJECTS:TemporalCoherenceEngine>
    $<TARGET_OBJECTS:TemporalCoherenceVolumes>
  NOWRAP_HEADERS
    "${module_directory}/vtkTemporalCoherenceCompatibility.h"
  HEADERS
    "${module_directory}/vtkTemporalCoherenceBrickSource.h"
    "${module_directory}/vtkTemporalCoherenceDropInMapper.h"
    "${module_directory}/vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
    "${module_directory}/vtkTemporalCoherenceObjectFactory.h"
    "${module_directory}/vtkTemporalCoherencePaperMapper.h"
    "${module_directory}/vtkTemporalCoherencePicker.h"
    "${module_directory}/vtkTemporalCoherencePresets.h"
    "${module_directory}/vtkTemporalCoherenceRefiner.h"
    "${module_directory}/vtkTemporalCoherenceStatistics.h"
    "${module_directory}/vtkTemporalCoherenceView.h"
    "${module_directory}/vtkTemporalCoherenceViewWriter.h"
    "${module_directory}/vtkTemporalCoherenceVolume.h"
    "${module_directory}/vtkTemporalCoherenceVolumeMapper.h")
vtk_module_include(VTK::TemporalCoherence
  PUBLIC
    "$<BUILD_INTERFACE:${module_directory}>"
  PRIVATE
    "${module_directory}/Engine"
    "${module_directory}/Vtk"
    ${volume_format_includes}
    "${view_page_includes}")
vtk_module_compile_features(VTK::TemporalCoherence PUBLIC cxx_std_17)
vtk_module_link(VTK::TemporalCoherence PRIVATE $<BUILD_INTERFACE:glm::glm> $<BUILD_INTERFACE:hwy::hwy>)
set(module_libraries ${volume_format_libraries} ${view_file_libraries})
list(REMOVE_DUPLICATES module_libraries)
foreach (library IN LISTS module_libraries)
  vtk_module_link(VTK::TemporalCoherence PRIVATE $<BUILD_INTERFACE:${library}>)
endforeach ()
if (volume_format_definitions)
  vtk_module_definitions(VTK::TemporalCoherence PRIVATE ${volume_format_definitions})
endif ()
# Only classes of VTK are for users of the library, whatever a build exports by default.
vtk_module_set_properties(VTK::TemporalCoherence
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON)

# One answer for every compiler: a product and a sum are rounded twice, never fused, as values on the
# faces between cells must be the same bits from both sides.
set(compile_options
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
# Inside VTK its own warnings are asked for: ours would be given for its headers, too.
if (PROJECT_NAME STREQUAL "vtkTemporalCoherence")
  list(APPEND compile_options
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wconversion>
    $<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<BOOL:${TEMPORAL_COHERENCE_WARNINGS_AS_ERRORS}>>:-Werror>)
endif ()
target_compile_options(TemporalCoherenceEngine PRIVATE ${compile_options})
target_compile_options(TemporalCoherenceVolumes PRIVATE ${compile_options})
# By the module's name: that of its target differs between versions of VTK.
vtk_module_compile_options(VTK::TemporalCoherence PRIVATE ${compile_options})
