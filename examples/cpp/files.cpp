// Reads two files, subtracts, writes: with every error that a user may cause. Usage: files A B OUT
#include <strata/strata.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 4) return std::cerr << "usage: files A B OUT\n", 2;
  try {
    const strata::Solid a(strata::read_mesh(argv[1]).mesh);
    const strata::Solid b(strata::read_mesh(argv[2]).mesh);
    const strata::Solid rest = a - b;
    for (const std::string& note : strata::write_mesh(argv[3], rest.exact_mesh())) std::cerr << note << '\n';
    std::cout << "volume " << strata::to_nearest_double(rest.volume()) << '\n';
  } catch (const strata::InputError& error) {  // no solid: every defect, with its place
    for (const strata::Defect& defect : error.defects()) std::cerr << strata::describe(defect) << '\n';
    return 4;
  } catch (const strata::IoError& error) {  // the message names the file and the line
    std::cerr << error.what() << '\n';
    return 3;
  }
}
