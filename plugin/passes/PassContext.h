#ifndef PassContext_h
#define PassContext_h

#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkTextureObject.h>
#include <vtkWeakPointer.h>

#include "View.h"

class vtkProp;
class vtkRenderState;
class vtkWindow;

namespace shadow
{

/// Makes a window's context current while it lives, and then again what was current before. For all that is
/// freed or read outside of the window's own picture: VTK drops the last reference to a pass whenever it
/// likes, also in the middle of another window's.
class ContextScope
{
public:
  explicit ContextScope(vtkOpenGLRenderWindow* theWindow) : window(theWindow) { this->window->PushContext(); }
  ~ContextScope() { this->window->PopContext(); }
  ContextScope(const ContextScope&) = delete;
  ContextScope& operator=(const ContextScope&) = delete;

private:
  vtkOpenGLRenderWindow* window;
};

/// The renderer and window that GL objects of a pass were made for, and whether these are still there.
class PassContext
{
public:
  PassContext(vtkOpenGLRenderer* theRenderer, vtkOpenGLRenderWindow* theWindow)
      : renderer(theRenderer), window(theWindow)
  {
  }

  vtkOpenGLRenderer* getRenderer() const { return this->renderer; }
  vtkOpenGLRenderWindow* getWindow() const { return this->window; }

  /// True when GL objects made since acquire() are gone with their context.
  bool isLost() const { return this->window == nullptr || this->sentinel->GetHandle() == 0; }

  /// Makes the context current.
  /// @param forget  called when it is not the one of the last time: GL objects are to be forgotten
  void acquire(const std::function<void()>& forget);

  /// Has @p free free the GL objects, with the context current, or forget them when it is lost.
  /// @post  what was current before is current again
  void release(const std::function<void(bool contextLost)>& free);

private:
  vtkWeakPointer<vtkOpenGLRenderer> renderer;
  vtkWeakPointer<vtkOpenGLRenderWindow> window;
  /// One texel that VTK frees with the window's context: tells whether our own GL objects are still there,
  /// also when the pass has been detached and nobody tells it.
  vtkNew<vtkTextureObject> sentinel;
};

/// Tells which messages of one renderer are news, so that what is wrong is said once and not in every frame.
class MessageFilter
{
public:
  /// @param message  of a rendering; empty when there is nothing to say
  /// @return whether it is to be said: it is not the one of the rendering before
  bool isNews(const std::string& message)
  {
    const bool news = !message.empty() && message != this->last;
    this->last = message;
    return news;
  }

private:
  std::string last;
};

/// What a pass keeps for each of the renderers that it serves.
///
/// @tparam State  made from renderer and window, with their PassContext as `Context`, and methods Release()
/// and GetMemorySize()
template <class State>
class RendererStates
{
public:
  /// The renderer's; made anew when there is none or it has come into another window. Drops those of
  /// renderers that are gone.
  State& get(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window)
  {
    for (auto entry = this->states.begin(); entry != this->states.end();)
    {
      entry = entry->second->Context.getRenderer() == nullptr ? this->states.erase(entry) : std::next(entry);
    }
    std::unique_ptr<State>& state = this->states[renderer];
    if (state == nullptr || state->Context.getWindow() != window)
    {
      state = std::make_unique<State>(renderer, window);
    }
    return *state;
  }

  void release(vtkWindow* window)
  {
    for (auto& entry : this->states)
    {
      if (entry.second->Context.getWindow() == window)
      {
        entry.second->Release();
      }
    }
  }

  /// Bytes of all.
  std::size_t getMemorySize() const
  {
    std::size_t bytes = 0;
    for (const auto& entry : this->states)
    {
      bytes += entry.second->GetMemorySize();
    }
    return bytes;
  }

private:
  std::map<vtkOpenGLRenderer*, std::unique_ptr<State>> states;
};

/// The matrices and the viewport that VTK is about to draw with.
View currentView(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

/// Why nothing can be drawn with a view: its matrix is beyond single precision or not finite. Else empty.
std::string findFault(const View& view);

/// The props that VTK draws with a state: those that its cullers have left.
std::set<vtkProp*> drawnProps(const vtkRenderState* s);

/// Props that something has been switched off for. They are not kept alive.
class PropExclusions
{
public:
  void set(vtkProp* prop, bool excluded);
  bool has(vtkProp* prop) const;

private:
  std::map<vtkProp*, vtkWeakPointer<vtkProp>> props;
};

} // namespace shadow

#endif
