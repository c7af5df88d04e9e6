"""A recipe for Conan 2: conan create packaging/conan. With the option system=True the libraries of the system are taken."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Strata(ConanFile):
    name = "strata"
    license = "Apache-2.0"
    description = "Exact Booleans of solids given as triangle meshes, on the doubles given"
    topics = ("mesh", "boolean", "csg", "exact", "geometry")
    settings = "os", "compiler", "build_type", "arch"
    options = {"system": [True, False], "gmp": [True, False], "assimp": [True, False]}
    default_options = {"system": False, "gmp": True, "assimp": False}
    package_type = "static-library"
    root = os.path.join("..", "..")

    def set_version(self):
        text = load(self, os.path.join(self.recipe_folder, self.root, "CMakeLists.txt"))
        self.version = re.search(r"project\(strata VERSION ([0-9.]+)", text)[1]

    def export_sources(self):
        root = os.path.join(self.recipe_folder, self.root)
        for pattern in ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "cmake/*", "include/*", "lib/*.cpp", "lib/*.h", "lib/*.txt",
                        "python/THIRD_PARTY_LICENSES.txt"):
            copy(self, pattern, root, self.export_sources_folder)

    def requirements(self):
        if self.options.system:
            return
        self.requires("onetbb/2021.12.0", transitive_headers=False)
        self.requires("boost/1.83.0", headers=True)
        self.requires("nlohmann_json/3.11.3")
        self.requires("pugixml/1.14")
        self.requires("zlib/1.3.1")
        if self.options.gmp:
            self.requires("gmp/6.3.0")
        if self.options.assimp:
            self.requires("assimp/5.4.1")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update({
            "STRATA_BUILD_TOOLS": False, "STRATA_BUILD_TESTS": False, "STRATA_BUILD_ORACLE": False, "STRATA_INSTALL": True,
            "STRATA_WITH_LIBDEFLATE": False, "STRATA_WITH_PNG": False, "STRATA_WITH_FONTS": False,
            "STRATA_WITH_GMP": bool(self.options.gmp),
            "STRATA_WITH_ASSIMP": bool(self.options.assimp)})
        toolchain.generate()
        if not self.options.system:
            CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        """The package's own CMake files are the ones to use."""
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "strata")]
