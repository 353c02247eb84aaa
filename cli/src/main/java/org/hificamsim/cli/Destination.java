package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.FileRecord;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.SeparateFiles;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * Protects files from being replaced: a command never writes over its inputs, and over an existing
 * file only with {@code --force}.
 */
final class Destination {
  /** The options that name outputs; paths of all other options are inputs. */
  static final Set<String> OUTPUTS =
      Set.of(
          "--out",
          "--png",
          "--svg",
          "--gif",
          "--output",
          "--summaryfile",
          "--coverage-out",
          "--for-camsim");

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(names = "--force")
  private boolean force;

  /** Whether an existing file may be replaced. */
  boolean force() {
    return force;
  }

  /**
   * Returns a file to write.
   *
   * @throws InputException when the file is an input, or exists and there is no {@code --force}
   */
  OutputFile file(String option, Path path) throws IOException {
    requireNoInput(option, path);
    return OutputFile.of(option, path, force);
  }

  /** Returns a file to write, in a folder that is made if it is missing. */
  OutputFile inFolder(String option, Path path) throws IOException {
    requireNoInput(option, path);
    return OutputFile.inFolder(option, path, force);
  }

  /** Returns a folder to write into, in which the inputs of the command are protected. */
  static OutputFolder folder(CommandSpec command, Path path) {
    OutputFolder folder = new OutputFolder(path);
    folder.keep(inputs(command).filter(Files::isRegularFile).toList());
    return folder;
  }

  /** Checks before the work that files may be written into a folder, without making the folder. */
  static void claim(CommandSpec command, Path path, List<String> names) throws IOException {
    if (Files.isDirectory(path)) {
      try (OutputFolder folder = folder(command, path)) {
        folder.claim(names);
      }
    }
  }

  /** Checks that an output is neither an input nor a result in a folder that is an input. */
  void requireNoInput(String option, Path output) throws IOException {
    Path real = SeparateFiles.real(output);
    for (Path input : inputs(command).map(SeparateFiles::real).toList()) {
      if (real.equals(input) || isResult(input, real)) {
        throw InputException.of(
            "what the command reads and %s are one file, '%s', expected two", option, output);
      }
    }
  }

  private static boolean isResult(Path folder, Path file) throws IOException {
    return file.startsWith(folder)
        && Files.exists(file, LinkOption.NOFOLLOW_LINKS)
        && FileRecord.of(folder).names().contains(folder.relativize(file).toString());
  }

  /** The existing files and folders that words of the command, or parts of words, name. */
  private static Stream<Path> inputs(CommandSpec command) {
    return command.commandLine().getParseResult().matchedArgs().stream()
        .filter(Destination::isInput)
        .flatMap(arg -> arg.originalStringValues().stream())
        .flatMap(word -> Stream.concat(Stream.of(word), Arrays.stream(word.split("[,:=@]"))))
        .filter(word -> !word.isBlank() && word.indexOf('\0') < 0)
        .map(Path::of)
        .filter(Files::exists);
  }

  private static boolean isInput(ArgSpec arg) {
    return !(arg instanceof OptionSpec option)
        || Arrays.stream(option.names()).noneMatch(OUTPUTS::contains);
  }
}
