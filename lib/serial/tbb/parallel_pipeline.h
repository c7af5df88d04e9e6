#pragma once
#include <cstddef>
#include <functional>
#include <utility>

namespace tbb {

enum class filter_mode { parallel, serial_in_order };

/// What the first filter ends the input with; what it returns then is dropped.
class flow_control {
 public:
  void stop() { is_stopped_ = true; }
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

 private:
  bool is_stopped_ = false;
};

/// Filters from In to Out, one behind the other. The first has no input but a flow_control.
template <class In, class Out>
struct filter {
  std::function<Out(In)> work;
};
template <class Out>
struct filter<void, Out> {
  std::function<Out(flow_control&)> work;
};

template <class In, class Out, class Work>
[[nodiscard]] filter<In, Out> make_filter(filter_mode, const Work& work) {
  return {work};
}

template <class Middle, class Out>
[[nodiscard]] filter<void, Out> operator&(filter<void, Middle> first, filter<Middle, Out> second) {
  return {[first = std::move(first.work), second = std::move(second.work)](flow_control& control) -> Out {
    Middle item = first(control);
    if (control.is_stopped()) return Out();
    return second(std::move(item));
  }};
}

inline void parallel_pipeline(std::size_t /*under_way*/, const filter<void, void>& all) {
  for (flow_control control; !control.is_stopped();) all.work(control);
}

}  // namespace tbb
