// Renders the scenes of ImageScenes.h and compares them with stored pictures.
//
//   image_tests SCENE THRESHOLD BASELINES RESULTS   one scene; fails when more than THRESHOLD per cent of the
//   pixels differ image_tests --update BASELINES RESULTS          all scenes; rewrites the stored pictures
//   that differ

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <vtkImageData.h>

#include "ImageScenes.h"
#include "Picture.h"

using namespace shadow::test;
using shadow::truth::ShadowScene;

namespace
{

vtkSmartPointer<vtkImageData> renderScene(const std::string& name, bool shadows = true)
{
  ShadowScene scene(320, 240);
  imageScenes().at(name)(scene);
  scene.pass->SetShadowIntensity(shadows ? 1.0 : 0.0);
  vtkSmartPointer<vtkImageData> picture = takePicture(scene.window);
  if (scene.pass->GetStatus() != vtkShadowVolumePass::STATUS_OK)
  {
    throw std::runtime_error(scene.pass->GetStatusMessage());
  }
  return picture;
}

/// A picture that is just as well without shadows tests nothing.
bool wouldNoticeLostShadows(const std::string& name, double threshold, vtkImageData* picture)
{
  const double lost = comparePictures(renderScene(name, false), picture).percent;
  std::cout << name << ": without shadows " << lost << " % would differ\n";
  if (lost < 4.0 * threshold)
  {
    std::cerr << name << ": a threshold of " << threshold << " % is too wide to notice lost shadows\n";
    return false;
  }
  return true;
}

bool compareScene(const std::string& name, double threshold, const std::string& baselines,
                  const std::string& results)
{
  const vtkSmartPointer<vtkImageData> picture = renderScene(name);
  const std::string place = results + "/" + name;
  writePicture(picture, place + ".png");
  const std::string baselineFile = baselines + "/" + name + ".png";
  const vtkSmartPointer<vtkImageData> baseline = readPicture(baselineFile);
  if (baseline == nullptr)
  {
    std::cerr << name << ": there is no stored picture " << baselineFile << "\nThe picture is now in "
              << place << ".png; look at it, then build the target update-baselines.\n";
    return false;
  }
  const PictureDifference difference = comparePictures(picture, baseline);
  std::cout << name << ": " << difference.percent << " % of the pixels differ, " << threshold << " % may\n";
  if (difference.image != nullptr)
  {
    writePicture(difference.image, place + "-difference.png");
  }
  if (difference.percent > threshold)
  {
    std::cerr << name << ": see " << place << ".png and " << place << "-difference.png against "
              << baselineFile << "\n";
    return false;
  }
  return wouldNoticeLostShadows(name, threshold, picture);
}

void updateBaselines(const std::string& baselines)
{
  int changed = 0;
  for (const auto& scene : imageScenes())
  {
    const std::string file = baselines + "/" + scene.first + ".png";
    const vtkSmartPointer<vtkImageData> picture = renderScene(scene.first);
    const vtkSmartPointer<vtkImageData> before = readPicture(file);
    const PictureDifference difference =
        before != nullptr ? comparePictures(picture, before) : PictureDifference{};
    if (!difference.identical)
    {
      writePicture(picture, file);
      ++changed;
      std::cout << scene.first << ": "
                << (before != nullptr ? std::to_string(difference.percent) + " % changed" : "new") << "\n";
    }
  }
  std::cout << changed << " of " << imageScenes().size() << " stored pictures were written\n";
}

int usage()
{
  std::cerr << "usage: image_tests SCENE THRESHOLD BASELINES RESULTS\n       image_tests --update BASELINES "
               "RESULTS\n";
  return EXIT_FAILURE;
}

} // namespace

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try
  {
    if (arguments.size() == 3 && arguments[0] == "--update")
    {
      updateBaselines(arguments[1]);
      return EXIT_SUCCESS;
    }
    if (arguments.size() != 4 || imageScenes().count(arguments[0]) == 0)
    {
      return usage();
    }
    std::filesystem::create_directories(arguments[3]);
    return compareScene(arguments[0], std::stod(arguments[1]), arguments[2], arguments[3]) ? EXIT_SUCCESS
                                                                                           : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << "image_tests: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
