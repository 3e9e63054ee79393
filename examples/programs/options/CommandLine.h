#ifndef shadow_examples_CommandLine_h
#define shadow_examples_CommandLine_h

#include "RenderOptions.h"

#include <memory>
#include <string>

namespace shadow::examples
{

/// What the programs say differently about the options that they share.
struct CommandLineTexts
{
  std::string program;
  std::string description;
  std::string output; ///< name of the picture when none is given
  std::string mask;   ///< what --mask writes
};

/// The options that the programs share, and those that each adds to them.
///
/// Values are taken as text, and turned into numbers by OptionValues.h: the number parsing of CLI11 follows
/// the locale and takes "0x1p3" or trailing text.
class CommandLine
{
public:
  /// @param texts    copied
  /// @param options  filled in by parse(), and by addShadowOptions()'s; outlives this object
  CommandLine(const CommandLineTexts& texts, RenderOptions& options);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// How shadows are drawn: --stencil, --silhouette, --compositing, --samples.
  void addShadowOptions();

  /// An option of the program's own with a value.
  ///
  /// @param value         the text that was given; outlives this object
  /// @param meaning       for --help
  /// @param type          what the value is, for --help
  /// @param defaultValue  for --help; empty: none
  void addOption(const std::string& option, std::string& value, const std::string& meaning,
                 const std::string& type, const std::string& defaultValue);

  /// An option without a value.
  void addFlag(const std::string& option, bool& value, const std::string& meaning);

  /// Reads the command line; argv[0] is the program.
  ///
  /// @return  false when help is asked for, which RenderOptions::help then holds
  /// @throws UsageError  one line, for anything that is unknown, incomplete or out of range
  bool parse(int argc, const char* const* argv);

  /// Whether an option was given.
  bool isSet(const std::string& option) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};

} // namespace shadow::examples

#endif
