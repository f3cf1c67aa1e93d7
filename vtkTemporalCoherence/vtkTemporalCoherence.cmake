# The module's sources, for both ways to build it (inside VTK, stand-alone).
set(module_directory "${CMAKE_CURRENT_LIST_DIR}")
find_package(glm REQUIRED)
find_package(hwy REQUIRED)

set(engine_files
  Scene/FieldKind
  Scene/FrameKey
  Scene/FramePlanes
  Scene/RayBatch
  Scene/Region
  Scene/View
  Acceleration/ActiveCells
  Acceleration/FieldFingerprint
  Acceleration/FieldStructures
  Acceleration/FiniteRange
  Acceleration/HiddenCells
  Acceleration/KernelsPyramid
  Acceleration/SampleComparer
  Acceleration/TileBounds
  Acceleration/ValueRangePyramid
  Trace/KernelsCrossing
  Trace/KernelsRange
  Trace/KernelsRays
  Trace/KernelsWalk
  Trace/RayPieces
  Trace/RaySource
  Trace/RegionClipper
  Trace/SurfaceTracer
  Mesh/CellPoints
  Mesh/HexahedronRoots
  Mesh/KernelsCellGradients
  Mesh/KernelsHexahedra
  Mesh/KernelsHexahedronSpans
  Mesh/KernelsKnownTetrahedra
  Mesh/KernelsTetrahedra
  Layers/KnownLayers
  Layers/LimitedLayers
  Layers/RecoloredLayers
  Shade/CapNormal
  Shade/HitGathering
  Shade/KernelsCells
  Shade/KernelsGradients
  Shade/KernelsRectilinear
  Shade/KernelsShading
  Shade/LayerShader
  Shade/RectilinearGradients
  Shade/Shader
  Shade/SurfaceNormal
  Shade/TileCompositor
  Shade/TileShader
  Blending/KernelsEmission
  Blending/KernelsVolumeSegments
  Blending/TransferTables
  Blending/VisibleBands
  Composite/CompositeTracer
  Composite/EmissionArcs
  Composite/KernelsCompositeBeam
  Sampling/ComponentLooks
  Sampling/ConvergedTracer
  Sampling/KernelsMedium
  Sampling/LookTables
  Sampling/Medium
  Sampling/MediumParts
  Sampling/MediumTables
  Sampling/PhongLight
  Sampling/SampledTracer
  Sampling/VisibleComponents
  Projections/ExtremeLook
  Projections/FieldProbe
  Projections/ImageShares
  Projections/KernelsExtremes
  Projections/KernelsShares
  Projections/MetValues
  Projections/ProjectionTracer
  Projections/ShareTable
  Projections/ShareTracer
  ImageCache/FreeSpace
  ImageCache/FreeSpaceHint
  ImageCache/ImageCache
  ImageCache/ImageHint
  ImageCache/ImageQuery
  ImageCache/KernelsImage
  ImageCache/PaperHint
  Isomap/BandBuilder
  Isomap/BandPlan
  Isomap/BandTracer
  Isomap/FrameBands
  Isomap/GroupCosts
  Isomap/Isomap
  Isomap/IsomapBuilder
  Isomap/IsomapLookup
  Isomap/KnotCollector
  Isomap/Knots
  Isomap/RangeBuild
  Isomap/TileGroups
  Beams/BeamChoice
  Beams/KernelsBandBeam
  Beams/KernelsBeam
  Beams/KernelsBeamSetUp
  Beams/KernelsCellValues
  Beams/KernelsLayerBeam
  Beams/KernelsMetCells
  Fields/ExtremeSearches
  Fields/KernelsCorners
  Fields/RectilinearKind
  Fields/SegmentSources
  Fields/UniformBandTracer
  Fields/UniformBlending
  Fields/UniformKind
  Fields/UniformTracer
  Trees/MeshBoxes
  Trees/MeshCheck
  Trees/MeshLeaves
  Trees/MeshOrder
  Trees/MeshRanges
  Trees/MeshRuns
  Trees/MeshTree
  Trees/RadixSort
  MeshTiles/ActiveLeaves
  MeshTiles/BoxLevels
  MeshTiles/CellCuts
  MeshTiles/CellFolds
  MeshTiles/CellValues
  MeshTiles/KernelsBoxes
  MeshTiles/KernelsMeshRays
  MeshTiles/KernelsOutlines
  MeshTiles/KernelsTileGrid
  MeshTiles/PreparedCells
  MeshTiles/PreparedLeaves
  MeshTiles/SeenStrip
  MeshFields/KernelsDistinct
  MeshFields/KernelsHitPlaces
  MeshFields/KernelsSortedTetrahedra
  MeshFields/MeshBandRays
  MeshFields/MeshBandTracer
  MeshFields/MeshCellSearch
  MeshFields/MeshGradients
  MeshFields/MeshKind
  MeshFields/MeshPlaces
  MeshFields/MeshSolids
  MeshFields/MeshTracer
  Render/BlendRoute
  Render/CapTiles
  Render/FrameRenderer
  Render/FrameStore
  Render/FrameStructures
  Render/IsomapRoute
  Render/LayerLimit
  Render/LineTracer
  Render/ReusePlan
  Render/Routes
  Render/SampleDistance
  Render/TileTracer)
list(TRANSFORM engine_files PREPEND "${module_directory}/Engine/")
list(TRANSFORM engine_files APPEND ".cxx")

set(bridge_files
  Input/BlockCopy
  Input/FieldFromImage
  Input/HiddenCellsFromImage
  Input/ImageLattice
  Input/ImageOfGrid
  Input/ImageSource
  Input/MergedBlocks
  Input/SampleMask
  Input/SamplesOfArray
  Input/ScalarChoice
  Input/SettingCheck
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
  Adaptive/AmrNeighbours
  Adaptive/LeafSearch
  Grids/CellOrigins
  Grids/CellTypes
  Grids/GridCells
  Grids/GridLeaves
  Grids/GridMesh
  Grids/GridPoints
  Grids/GridShape
  Grids/GridValues
  Grids/MadeFrom
  Grids/MeshDefectText
  Grids/MeshSource
  Grids/MissingCells
  Grids/SameCells
  Window/DepthReader
  Window/LayerDepthClip
  Window/OpenGLWindow
  Window/PassOutput
  Window/PeeledLayers
  Window/PeeledPicture
  Window/PeelingPass
  Window/PeelPresenter
  Window/PicturePresenter
  Window/PixelHit
  Window/PixelRays
  Window/RayEnds
  Window/WindowPicture
  Window/WindowRays
  Request/AppearanceFromVolume
  Request/BlendingFromVolume
  Request/DirectColors
  Request/DrawnVolume
  Request/EmptyInput
  Request/EmptyPicture
  Request/FieldFromMapper
  Request/GradientOpacityFromVolume
  Request/IsovalueCheck
  Request/LightsFromRenderer
  Request/RegionFromMapper
  Request/RequestFromMapper
  Request/SampledTransfer
  Request/TransferNodes
  Request/TransferSamples
  Request/ViewFromRenderer
  Output/BufferImages
  Output/ImageFromFrame
  Output/PointsFromFrame
  Frames/MapperFrames
  Frames/SelectionPass
  Frames/ViewerStates)
list(TRANSFORM bridge_files PREPEND "${module_directory}/Vtk/")
list(TRANSFORM bridge_files APPEND ".cxx")

# The engine is one object library: the module and the engine's own tests are made of it.
add_library(TemporalCoherenceEngine OBJECT ${engine_files})
target_compile_features(TemporalCoherenceEngine PUBLIC cxx_std_17)
set_target_properties(TemporalCoherenceEngine PROPERTIES
  POSITION_INDEPENDENT_CODE ON
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON)
# Vectors whose size is not known when they are compiled cannot be kept in arrays, as kernels do.
target_compile_definitions(TemporalCoherenceEngine PUBLIC
  "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV)")
target_include_directories(TemporalCoherenceEngine PUBLIC
  "$<BUILD_INTERFACE:${module_directory}/Engine>")
target_link_libraries(TemporalCoherenceEngine PUBLIC VTK::CommonCore glm::glm hwy::hwy)

vtk_module_add_module(VTK::TemporalCoherence
  SOURCES
    "${module_directory}/GpuMapperSettings.cxx"
    "${module_directory}/SettingsFromMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceDropInMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceGPUVolumeRayCastMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceObjectFactory.cxx"
    "${module_directory}/vtkTemporalCoherencePaperMapper.cxx"
    "${module_directory}/vtkTemporalCoherencePicker.cxx"
    "${module_directory}/vtkTemporalCoherenceVolume.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapper.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperInternals.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperLastFrame.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperPicking.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperSettings.cxx"
    "${module_directory}/vtkTemporalCoherenceVolumeMapperStatistics.cxx"
    ${bridge_files}
    $<TARGET_OBJECTS:TemporalCoherenceEngine>
  NOWRAP_HEADERS
    "${module_directory}/vtkTemporalCoherenceCompatibility.h"
  HEADERS
    "${module_directory}/vtkTemporalCoherenceDropInMapper.h"
    "${module_directory}/vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
    "${module_directory}/vtkTemporalCoherenceObjectFactory.h"
    "${module_directory}/vtkTemporalCoherencePaperMapper.h"
    "${module_directory}/vtkTemporalCoherencePicker.h"
    "${module_directory}/vtkTemporalCoherenceVolume.h"
    "${module_directory}/vtkTemporalCoherenceVolumeMapper.h")
vtk_module_include(VTK::TemporalCoherence
  PUBLIC
    "$<BUILD_INTERFACE:${module_directory}>"
  PRIVATE
    "${module_directory}/Engine"
    "${module_directory}/Vtk")
vtk_module_compile_features(VTK::TemporalCoherence PUBLIC cxx_std_17)
vtk_module_link(VTK::TemporalCoherence PRIVATE $<BUILD_INTERFACE:glm::glm> $<BUILD_INTERFACE:hwy::hwy>)
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
# By the module's name: that of its target differs between versions of VTK.
vtk_module_compile_options(VTK::TemporalCoherence PRIVATE ${compile_options})
