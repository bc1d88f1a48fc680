// Linked to every program of a build with mutants. SBGC_MUTANT is the number of the mutant in
// effect. SBGC_REACHED names a file with a byte for each mutant; those that are executed become 1,
// even if the program is killed.
#include "switch.hpp"

#include <cstdlib>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace sbgc_mutant {

namespace {

constexpr auto most = 65536;
unsigned char nowhere[most];

volatile unsigned char* opened() {
  const auto* path = std::getenv("SBGC_REACHED");
  const auto file = path != nullptr ? open(path, O_RDWR | O_CLOEXEC) : -1;
  if (file < 0) return nowhere;
  auto* bytes = mmap(nullptr, most, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return bytes == MAP_FAILED ? nowhere : static_cast<volatile unsigned char*>(bytes);
}

int chosen() {
  const auto* number = std::getenv("SBGC_MUTANT");
  return number != nullptr ? std::atoi(number) : -1;
}

}  // namespace

// Before the constructors of other files, which may contain mutants.
__attribute__((init_priority(101))) const Switches switches{opened(), chosen()};

}  // namespace sbgc_mutant
