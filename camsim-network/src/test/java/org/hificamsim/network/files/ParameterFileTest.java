package org.hificamsim.network.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.bandit.BanditParameters;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the parameter file of option {@code -p}. */
class ParameterFileTest {
  @TempDir Path folder;

  private ParameterFile read(String text) throws IOException {
    return ParameterFile.read(Files.writeString(folder.resolve("p"), text));
  }

  @Test
  void emptyFileGivesCamSimDefaults() throws IOException {
    assertEquals(ParameterFile.DEFAULT, read("# nothing\n"));
  }

  @Test
  void readsEveryKeyIgnoringCase() throws IOException {
    ParameterFile file =
        read(
            "preinstantiationbidcoefficient=3\nOVERSTAYBIDCOEFFICIENT=-1.5\nDebugHist=true\n"
                + "ClassificationEnabled=TRUE\nObjectCategories=7\nHistPerCategoryEnabled=false\n"
                + "HistEnabled=False\nepsilon=0.3\nAlpha=1\nBETA=0.25\nGamma=0.75\nInterval=9\n");
    assertEquals(new HistoricalParameters(3, -1.5, true, 7, false, false), file.historical());
    assertEquals(new BanditParameters(0.3, 1, 0.25, 0.75, 9), file.bandit());
  }

  @Test
  void keepsNoCategoriesWithoutClassification() throws IOException {
    assertEquals(
        new HistoricalParameters(20, 0, false, 4, false, true),
        read("ClassificationEnabled=false\nHistPerCategoryEnabled=true").historical());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Epsilon=0 | Epsilon is '0', expected a number above 0",
        "alpha=1.01 | Alpha is '1.01', expected a number from 0.0 to 1.0",
        "Beta=-0.1 | Beta is '-0.1', expected a number from 0.0 to 1.0",
        "Gamma=x | Gamma is 'x', expected a number from 0.0 to 1.0",
        "Interval=0 | Interval is '0', expected a whole number from 1",
        "ObjectCategories=361 | ObjectCategories is '361', expected a whole number from 1 to 360",
        "HistEnabled=yes | HistEnabled is 'yes', expected one of false, true",
        "DebugHist=1 | DebugHist is '1', expected one of false, true",
        "Speed=1 | unknown option 'Speed=1', expected one of",
        "Alpha=0.1,0.2 | Alpha is '0.1,0.2'",
      })
  void errorsNameFileAndKey(String text, String expected) {
    InputException error = assertThrows(InputException.class, () -> read(text));
    assertTrue(
        error.getMessage().startsWith(folder.resolve("p") + ": " + expected), error.getMessage());
  }
}
