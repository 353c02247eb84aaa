package org.hificamsim.cli;

import picocli.CommandLine.Option;

/** {@code --seed}: any whole number of 64 bits. */
final class SeedOption {
  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "Seed of all chance; where there are repeats, i uses seed + i.")
  private long seed;

  long value() {
    return seed;
  }
}
