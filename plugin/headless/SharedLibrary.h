#ifndef SharedLibrary_h
#define SharedLibrary_h

#include <initializer_list>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace shadow
{

/// A library that is loaded when it is first needed and stays loaded. Its symbols stand in for nobody else's.
class SharedLibrary
{
public:
  /// Loads the first of these that there is. @throws std::runtime_error with what the loader says of the
  /// first name when there is none
  SharedLibrary(std::initializer_list<const char*> names, const std::string& missing)
  {
    std::string reason;
    for (const char* name : names)
    {
      this->handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (this->handle != nullptr)
      {
        return;
      }
      const char* said = dlerror();
      reason = reason.empty() && said != nullptr ? said : reason;
    }
    throw std::runtime_error(missing + ": " + reason);
  }

  /// @throws std::runtime_error when there is no such function
  template <class Function>
  void find(const char* name, Function*& function) const
  {
    function = reinterpret_cast<Function*>(dlsym(this->handle, name));
    if (function == nullptr)
    {
      throw std::runtime_error(dlerror());
    }
  }

private:
  void* handle = nullptr;
};

} // namespace shadow

#endif
