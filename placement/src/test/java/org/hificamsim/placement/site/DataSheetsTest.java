package org.hificamsim.placement.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of camera catalogues. */
class DataSheetsTest {
  @TempDir private Path folder;

  private PriceList read(String table, boolean withHeights) throws IOException {
    Path file = Files.writeString(folder.resolve("cameras.csv"), table.replace("|", "\n"));
    return DataSheets.read(file, withHeights);
  }

  @Test
  void lensOfProductIsReadAsRangeStepsOrFocalLengths() throws IOException {
    PriceList list =
        read(
            "name,resolution,hfov,focal,sensor,pan,price,currency"
                + "|range,3840x2160,33-105,,,,520,CHF"
                + "|steps,1920,30 60 90,,,,200,CHF"
                + "|zoom,2592x1944,,2.8-12,5.37,,340,CHF"
                + "|dome,1920,60,,,180,1100,CHF",
            true);
    assertEquals("CHF", list.currency());
    assertEquals(List.of("range", "steps", "zoom", "dome"), list.names());
    assertEquals(List.of(33.0, 48.5, 71.4, 105.0), angles(list, 0));
    assertEquals(List.of(30.0, 60.0, 90.0), angles(list, 1));
    assertEquals(25.2, angles(list, 2).get(0), "2 atan(5.37 / 24)");
    assertEquals(87.6, angles(list, 2).get(3), "2 atan(5.37 / 5.6)");
    assertEquals(4 / 3.0, list.kinds().get(2).optics().find(OpticsSpec.ASPECT).orElseThrow());
    assertTrue(list.kinds().get(0).optics().find(OpticsSpec.ASPECT).isEmpty(), "usual");
    assertEquals(24, list.kinds().get(3).optics().pans().size());
    assertEquals(3840, list.kinds().get(0).optics().get(OpticsSpec.PIXELS));
  }

  private static List<Double> angles(PriceList list, int kind) {
    return list.kinds().get(kind).optics().anglesOfView();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "name,resolution,hfov,height_min,price|a,1920,60,2,9; column is 'height_min', expected any"
            + " of name",
        "name,resolution,price|a,1920,9; csv:2:1: name is 'a', expected one of hfov in degrees",
        "name,resolution,hfov,focal,sensor,price|a,1920,60,4,5,9; csv:2:8: hfov is '60', expected"
            + " one of hfov",
        "name,resolution,focal,price|a,1920,4,9; csv:2:8: focal is '4', expected a column sensor",
        "name,resolution,hfov,price|a,full HD,60,9; csv:2:3: resolution is 'full HD', expected"
            + " pixels",
        "name,resolution,hfov,price|a,1920,wide,9; csv:2:8: hfov is 'wide', expected degrees from"
            + " 0.1 to 179.0",
        "name,resolution,hfov,price|a,1920,30-190,9; csv:2:8: hfov is '30-190', expected degrees",
        "name,resolution,hfov,price|a,1920,60,0; csv:2:11: price is '0', expected a number from",
        "name,resolution,hfov,price|a,1920,60,9|a,1920,60,9; csv:3:1: name is 'a', expected a name",
        "name,resolution,hfov,price,currency|a,1920,60,9,EUR|b,1920,60,9,CHF; csv:3:13: currency is"
            + " 'CHF', expected that of all other rows, EUR",
        "name,resolution,hfov,price; csv:1:1: the table has no camera",
      })
  void errorNamesPlaceOfInvalidCell(String table, String message) {
    InputException wrong = assertThrows(InputException.class, () -> read(table, false));
    assertTrue(wrong.getMessage().contains(message), wrong.getMessage());
  }
}
