package org.hificamsim.spark;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;

/** The Spark distribution that tests use. */
final class SparkHome {
  private static final Path HOME = Path.of(System.getProperty("spark.home", "none"));

  private SparkHome() {}

  /** The folder of Spark; the test is skipped if there is none. */
  static Path require() {
    assumeTrue(Files.isDirectory(HOME.resolve("jars")), "no Spark in " + HOME);
    return HOME;
  }
}
