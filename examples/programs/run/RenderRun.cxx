#include "RenderRun.h"

#include "Camera.h"
#include "Lights.h"
#include "OutputFiles.h"
#include "Report.h"
#include "SceneSetup.h"
#include "UserError.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>

#include <unistd.h>

namespace shadow::examples
{
namespace
{

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

constexpr double gigabyte = 1e9;
constexpr double largePicture = 32e6; ///< pixels from which on it is told what a picture takes
constexpr int mostSamples = 4;        ///< that software GL gives

/// What drawing takes of the machine's memory, about: measured on software GL, where it is all of it.
double estimateBytes(const SizeOption& size, int samples)
{
  return 0.15 * gigabyte + static_cast<double>(size.width) * size.height * (20.0 + 22.0 * std::min(samples, mostSamples));
}

double getMachineBytes()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string toGigabytes(double bytes)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(bytes < 10.0 * gigabyte ? 1 : 0) << bytes / gigabyte << " GB";
  return text.str();
}

} // namespace

RenderRun::RenderRun(std::string givenProgram, RenderOptions given, std::size_t maskCount)
    : options(std::move(given)), program(std::move(givenProgram)), names(this->options, maskCount),
      frameCount(options.frames.value_or(1)), progress(program), frameReports(nlohmann::ordered_json::array())
{
}

RenderRun::~RenderRun() = default;

void RenderRun::run()
{
  this->names.check();
  this->readModels();
  this->openWindow();
  this->setUpScene();
  for (int frame = 0; frame < this->frameCount; ++frame)
  {
    this->progress.show("frame " + std::to_string(frame + 1) + " of " + std::to_string(this->frameCount));
    this->drawFrame(frame);
    this->checkDrawing();
    this->checkMessages();
    this->writeFrame(frame);
  }
  this->writeReport();
}

std::vector<LightOption> RenderRun::lightsOf(int frame) const
{
  Vector3 centre;
  this->modelBounds.GetCenter(centre.data());
  std::vector<LightOption> lights;
  for (const LightOption& light : this->options.lights)
  {
    lights.push_back(frame == 0 ? light : turnLight(light, centre, 360.0 * frame / this->frameCount));
  }
  return lights;
}

void RenderRun::readModels()
{
  for (const std::string& file : this->options.models)
  {
    this->progress.show("reading " + file);
    std::vector<std::string> warnings;
    this->models.push_back(readModel(file, this->program, warnings));
    for (const std::string& warning : warnings)
    {
      this->warn(file + ": " + warning);
    }
  }
}

void RenderRun::openWindow()
{
  const SizeOption& size = this->options.size;
  this->window->SetMultiSamples(this->options.samples > 1 ? this->options.samples : 0);
  this->window->SetSize(64, 64);
  this->window->Render(); // of nothing: VTK asks the GL for its limits not before the first picture
  if (!this->window->IsUsable())
  {
    throw UserError(
        "there is no OpenGL context to draw into" +
        (this->messages.errors().empty() ? std::string() : ": " + this->messages.errors().front()));
  }
  const int limit = vtkTextureObject::GetMaximumTextureSize(this->window);
  if (size.width > limit || size.height > limit)
  {
    throw UserError("--size: " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                    " is over the limit of this GL, " + std::to_string(limit) + "x" + std::to_string(limit));
  }
  this->checkMemory();
  this->window->SetSize(size.width, size.height);
}

void RenderRun::checkMemory()
{
  const SizeOption& size = this->options.size;
  const std::string name =
      "--size: a picture of " + std::to_string(size.width) + "x" + std::to_string(size.height);
  const double bytes = estimateBytes(size, this->options.samples);
  if (bytes > getMachineBytes())
  {
    throw UserError(name + " takes about " + toGigabytes(bytes) + " of memory, and this machine has " +
                    toGigabytes(getMachineBytes()));
  }
  if (static_cast<double>(size.width) * size.height > largePicture)
  {
    this->warn(name + " takes about " + toGigabytes(bytes) + " of memory and, without a GPU, up to minutes");
  }
}

void RenderRun::setUpScene()
{
  this->modelBounds = this->options.models.empty() ? addBuiltInScene(this->renderer)
                                                   : addModels(this->renderer, this->models);
  this->modelPoints = samplePoints(this->renderer);
  vtkBoundingBox floor;
  if (this->options.floor)
  {
    floor = addFloor(this->renderer, this->modelBounds);
  }
  if (this->options.lights.empty())
  {
    this->options.lights.push_back(chooseLight(this->modelBounds));
  }
  this->checkLights(floor);
  this->setUpView();

  setBackground(this->renderer);
  this->attachPasses(this->renderer);
  this->window->AddRenderer(this->renderer);
}

void RenderRun::setUpView()
{
  const SizeOption& size = this->options.size;
  if (!this->options.camera)
  {
    CameraSubject subject;
    subject.points = this->modelPoints;
    subject.aspect = static_cast<double>(size.width) / size.height;
    if (this->options.floor)
    {
      subject.floorHeight = this->modelBounds.GetMinPoint()[1];
    }
    for (int frame = 0; frame < this->frameCount; ++frame)
    {
      const std::vector<LightOption> lights = this->lightsOf(frame);
      subject.lights.insert(subject.lights.end(), lights.begin(), lights.end());
    }
    this->options.camera = chooseCamera(subject);
  }
  setCamera(this->renderer, *this->options.camera, this->options.parallelScale);
}

void RenderRun::checkLights(const vtkBoundingBox& floor) const
{
  for (std::size_t i = 0; i < this->options.lights.size(); ++i)
  {
    const LightOption& light = this->options.lights[i];
    if (!canReach(light, this->modelBounds) && !(floor.IsValid() && canReach(light, floor)))
    {
      throw UserError("--light: light " + std::to_string(i) + " reaches nothing: its cone misses the scene");
    }
  }
}

void RenderRun::drawFrame(int frame)
{
  this->messages.clear();
  this->said.clear();
  const std::vector<LightOption> lights = this->lightsOf(frame);
  setLights(this->renderer, lights);
  const auto start = std::chrono::steady_clock::now();
  this->window->Render();
  this->window->WaitForCompletion();
  const double milliseconds = millisecondsSince(start);

  nlohmann::ordered_json report = {{"picture", this->names.picture(frame)}};
  report["lights"] = describeLights(lights);
  report.update(this->describeFrame(milliseconds));
  this->frameReports.push_back(std::move(report));
}

void RenderRun::checkMessages()
{
  if (!this->messages.errors().empty())
  {
    throw UserError("drawing failed: " + this->messages.errors().front());
  }
  for (const std::string& warning : this->messages.warnings())
  {
    // a pass says the cause of its status as a warning, too
    if (this->said.find(warning) == std::string::npos)
    {
      this->warn(warning);
    }
  }
}

void RenderRun::checkStatus(bool complete, bool partial, const std::string& what, const std::string& cause)
{
  if (partial)
  {
    this->warn(cause);
  }
  else if (!complete)
  {
    throw UserError("no " + what + " could be drawn: " + cause);
  }
  this->said += cause;
}

void RenderRun::writeMask(const std::string& name, vtkImageData* mask, nlohmann::ordered_json& report) const
{
  writePng(name, mask);
  report["masks"].push_back(name);
}

void RenderRun::writeFrame(int frame)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  writePng(this->names.picture(frame), grab->GetOutput());
  if (!this->options.mask.empty())
  {
    this->writeMasks(frame, this->frameReports.back());
  }
}

void RenderRun::writeReport()
{
  if (this->options.report.empty())
  {
    return;
  }
  nlohmann::ordered_json report = {{"program", this->program}, {"version", VTKSHADOW_VERSION}};
  report["system"] = describeSystem(this->window);
  report["size"] = {this->options.size.width, this->options.size.height};
  report["models"] = describeModels(this->models);
  report["floor"] = this->options.floor;
  report["camera"] = describeCamera(*this->options.camera, this->options.parallelScale);
  report["settings"] = this->describeSettings();
  report["frames"] = this->frameReports;
  writeFile(this->options.report, toText(report));
}

void RenderRun::warn(const std::string& text)
{
  if (this->warned.insert(text).second)
  {
    this->progress.clear();
    std::cerr << this->program << ": warning: " << text << std::endl;
  }
}

} // namespace shadow::examples
