#pragma once

namespace tbb {

template <class... Works>
void parallel_invoke(const Works&... works) {
  (works(), ...);
}

}  // namespace tbb
