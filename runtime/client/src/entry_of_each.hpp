/// Objects that refer to a function for each of several messages, so that the compiler emits it.
#pragma once

#include <sbgc/type_list.hpp>

namespace sbgc::detail {

/// Derives from Entry<M> of every message M in a list. (A tuple of them compiles much slower.)
template <template <class> class Entry, class... Ms>
struct EntryOfEach : Entry<Ms>... {
  explicit EntryOfEach(TypeList<Ms...> /*messages*/) noexcept {}
};

/// Returns an object with an Entry of each message.
template <template <class> class Entry, class... Ms>
auto entries_for(TypeList<Ms...> messages) noexcept {
  return EntryOfEach<Entry, Ms...>(messages);
}

}  // namespace sbgc::detail
