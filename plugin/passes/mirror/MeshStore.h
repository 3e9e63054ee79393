#ifndef MeshStore_h
#define MeshStore_h

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkWeakPointer.h>

#include "SEDGeode.h"

class vtkPolyData;

namespace shadow
{

/// A SEDGeode for each data set, kept until the data set changes. First all are asked for, then what is new or has
/// changed is built at once, by all of VTK's threads.
class MeshStore
{
public:
  struct Options
  {
    double weldTolerance = 0.0;
    bool weldsRounding = false;   ///< see SceneBuilder::Settings
    bool copiesCountOnce = false; ///< see SEDGeometryOptions::copiesCountOnce
  };

  struct Mesh
  {
    std::shared_ptr<SEDGeode> geode; ///< none when the data cannot be used
    std::string error;               ///< then why, unless there is nothing to use
  };

  /// @param shownBefore  in the same place the last time, perhaps the same mesh at an earlier time; or nullptr
  void request(vtkPolyData* polyData, const std::shared_ptr<SEDGeode>& shownBefore, const Options& options);

  /// Builds what has been asked for and is not there.
  void build();

  /// @pre  asked for, and built, since the last dropUnused()
  const Mesh& get(vtkPolyData* polyData) const { return this->meshes.at(polyData).mesh; }

  /// Forgets data sets that nobody asked for since the last time.
  void dropUnused();

  /// Bytes of adjacency and volumes.
  std::size_t getMemorySize() const;

private:
  struct Entry
  {
    vtkWeakPointer<vtkPolyData> polyData; ///< guards against another data set at the same address
    vtkMTimeType time = 0;
    double weldTolerance = 0.0;
    Mesh mesh;
    bool used = false;
  };
  struct Pending
  {
    Entry* entry;
    vtkSmartPointer<vtkPolyData> polyData;
    std::shared_ptr<SEDGeode> previous;
    bool copiesCountOnce;
  };

  void buildRange(std::size_t begin, std::size_t end);

  std::map<vtkPolyData*, Entry> meshes;
  std::vector<Pending> pending;
};

} // namespace shadow

#endif
