#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <string_view>

#include "strata/io.h"

using namespace strata;

TEST_CASE("paths are texts or std::filesystem::path", "[io]") {
  const std::string text = "parts/wheel.obj";
  const std::filesystem::path path = text;
  CHECK(FilePath(text).text() == text);
  CHECK(FilePath("parts/wheel.obj").text() == text);
  CHECK(FilePath(std::string_view(text)).text() == text);
  CHECK(FilePath(std::string(text)).text() == text);
  CHECK(FilePath(path).text() == text);
#if !defined(_WIN32)
  CHECK(FilePath(path / "\xff").text() == text + "/\xff");  // bytes, not characters
#endif
  CHECK(format_of("a.STL") == Format::stl);
  CHECK(format_of(text) == Format::obj);
  CHECK(format_of(path) == Format::obj);
  CHECK_THROWS_AS(read_mesh(std::filesystem::path("/nowhere/at all.obj")), IoError);
  CHECK_THROWS_WITH(read_mesh("/nowhere/at all.obj"), Catch::Contains("/nowhere/at all.obj"));
}
