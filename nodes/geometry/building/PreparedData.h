#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <typeindex>
#include <typeinfo>
#include <utility>

namespace shadow
{

/// What algorithms work out from a mesh alone and want to find again: one entry a type, made when it is first
/// asked for, gone with the mesh it belongs to. May be asked by several threads.
class PreparedData
{
public:
  /// The entry of type T.
  ///
  /// @param parameter  what T depends on besides the mesh; the entry is made anew when it has changed
  /// @param make       makes a T; must not ask for prepared data itself. T needs getMemorySize()
  /// @return  stays as it is as long as the caller holds it
  template <class T, class Make>
  std::shared_ptr<const T> get(double parameter, Make&& make)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    Entry& entry = this->entries[std::type_index(typeid(T))];
    if (entry.data == nullptr || entry.parameter != parameter)
    {
      auto made = std::make_shared<const T>(std::forward<Make>(make)());
      entry.parameter = parameter;
      entry.bytes = made->getMemorySize();
      entry.data = std::move(made);
    }
    return std::static_pointer_cast<const T>(entry.data);
  }

  /// Bytes of all entries.
  std::size_t getMemorySize() const
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::size_t bytes = 0;
    for (const auto& entry : this->entries)
    {
      bytes += entry.second.bytes;
    }
    return bytes;
  }

private:
  struct Entry
  {
    double parameter = 0.0;
    std::size_t bytes = 0;
    std::shared_ptr<const void> data;
  };

  mutable std::mutex mutex;
  std::map<std::type_index, Entry> entries;
};

} // namespace shadow
