package org.hificamsim.core.energy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class EnergyModelTest {
  @TempDir Path folder;

  @Test
  void cc2420HasFiguresOfItsDataSheet() {
    EnergyModel model = EnergyModel.parse("cc2420");
    assertEquals(3 * 17.4e-3 / 250e3, model.figure(EnergyFigure.SEND), 1e-15);
    assertEquals(3 * 18.8e-3 / 250e3, model.figure(EnergyFigure.RECEIVE), 1e-15);
    assertFalse(model.hasBatteries());
  }

  @ParameterizedTest
  @CsvSource({
    "sense=12mJ, 0.012",
    "sense=0.5 J, 0.5",
    "sense=2uJ, 2e-6",
    "sense=1e3 nJ, 1e-6",
    "sense=2mWh, 7.2",
    "sense=.001kWh, 3600",
  })
  void readsUnits(String text, double joules) {
    assertEquals(joules, EnergyModel.parse(text).figure(EnergyFigure.SENSE), 1e-12 * joules);
  }

  @Test
  void givenFiguresReplaceThoseOfTheProfile() {
    EnergyModel model = EnergyModel.parse("cc2420,send=1uJ,idle=0.3W,battery=2kJ");
    assertEquals(1e-6, model.figure(EnergyFigure.SEND));
    assertEquals(0.3, model.figure(EnergyFigure.IDLE));
    assertEquals(2000, model.battery());
    assertEquals(model, EnergyModel.parse(model.text()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "cc2421",
        "sense=-1mJ",
        "sense=NaN",
        "sense=NaNJ",
        "sense=1",
        "sense=1W",
        "sense=1 foo",
        "idle=1J",
        "sense=1e999J",
        "smell=1J",
        "battery=0J",
        "battery=-5J",
        "battery=5",
        "",
        "sense=",
        "cc2420,cc2420",
        "sense=1J,idle",
      })
  void rejectsInvalidFiguresInOneLine(String text) {
    String message = assertThrows(InputException.class, () -> EnergyModel.parse(text)).getMessage();
    assertTrue(message.startsWith("energy: ") && message.contains("expected"), message);
    assertFalse(message.contains("\n"), message);
  }

  @Test
  void readsFileWithComments() throws IOException {
    Path file = folder.resolve("mote.energy");
    Files.writeString(file, "# my mote\ncc2420\nsense = 12 mJ # a frame\n\nbattery = 1 Wh\n");
    EnergyModel model = EnergyModel.parseOrRead(file.toString());
    assertEquals(EnergyModel.parse("cc2420,sense=12mJ,battery=3600J"), model);
  }

  @Test
  void errorNamesLineOfInvalidFigure() throws IOException {
    Path file = folder.resolve("mote.energy");
    Files.writeString(file, "cc2420\nsense = -12 mJ\n");
    InputException error =
        assertThrows(InputException.class, () -> EnergyModel.parseOrRead(file.toString()));
    assertTrue(error.getMessage().startsWith(file + ":2: energy: sense"), error.getMessage());
  }
}
