# find_package(flipbook): the targets flipbook::sim (transfers and solvers), flipbook::scene and flipbook::frame.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/flipbookTargets.cmake)
