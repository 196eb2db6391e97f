# SPDX-License-Identifier: Apache-2.0
# Every library that is not ours; all are Debian packages (see tools/packages.txt).
find_package(TBB REQUIRED)
find_package(Freetype REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(TIFF REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
if(DIOPTRE_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()
