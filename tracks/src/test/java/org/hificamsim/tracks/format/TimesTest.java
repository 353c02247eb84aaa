package org.hificamsim.tracks.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.time.OffsetDateTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TimesTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0|0",
        "-12.5|-12.5",
        "1e3|1000",
        "99999999999|99999999999",
        "1700000000|1700000000",
        "1700000000.25|1700000000.25",
        "1700000000250|1700000000.25",
        "1700000000250000|1700000000.25",
        "1700000000250000000|1700000000.25",
      })
  void readsSecondsAndUnixTimes(String text, double seconds) {
    assertEquals(seconds, new Times().seconds(text), 1e-6);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "2024-05-31T12:00:00Z|2024-05-31T12:00:00Z",
        "2024-05-31T12:00:00.125+02:00|2024-05-31T12:00:00.125+02:00",
        "2024-05-31T12:00:00+0200|2024-05-31T10:00:00Z",
        "2024-05-31T12:00:00-07|2024-05-31T19:00:00Z",
        "2024-05-31T12:00:00|2024-05-31T12:00:00Z",
        "2024-05-31 12:00:00.5|2024-05-31T12:00:00.500Z",
        "2024-05-31 12:00:00,5 UTC|2024-05-31T12:00:00.500Z",
        "2024-05-31T12:00|2024-05-31T12:00:00Z",
        "2024-05-31|2024-05-31T00:00:00Z",
        "2024/05/31 12:00:01|2024-05-31T12:00:01Z",
        "31.5.2024 12:00:01|2024-05-31T12:00:01Z",
        "20240531T120001Z|2024-05-31T12:00:01Z",
        "2024-05-31 01:02:03 PM|2024-05-31T13:02:03Z",
        "2024-02-29T00:00:00Z|2024-02-29T00:00:00Z",
      })
  void readsDates(String text, String iso) {
    OffsetDateTime time = OffsetDateTime.parse(iso);
    double seconds = time.toEpochSecond() + time.getNano() / 1e9;
    assertEquals(seconds, new Times().seconds(text), 1e-6);
  }

  @ParameterizedTest
  @CsvSource({
    "00:00:00, 0",
    "12:00:01.5, 43201.5",
    "'12:00:01,25', 43201.25",
    "1:02:03 am, 3723",
    "12:00:00 a.m., 0",
    "2:01:00:00, 176400",
    "25:00:00, 90000"
  })
  void readsTimesOfDay(String text, double seconds) {
    assertEquals(seconds, new Times().seconds(text), 1e-9);
  }

  @Test
  void continuesAfterMidnight() {
    Times times = new Times();
    assertEquals(86_390, times.seconds("23:59:50"));
    assertEquals(86_401, times.seconds("00:00:01"));
    assertEquals(86_395, times.seconds("23:59:55")); // of the next target
    assertEquals(86_402, times.seconds("00:00:02"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "noon",
        "NaN",
        "Infinity",
        "12:30",
        "13/31/2024",
        "13:00 pm",
        "2024-02-30",
        "2024-13-01",
        "1d",
        "0x10",
        "2024-05-31T25:61:00Z",
        "12:61:00",
        "1e40",
        "2024-05-31T12:00:00+99:00",
        "T12:00:00"
      })
  void rejectsTextsThatAreNotTimes(String text) {
    double seconds = new Times().seconds(text);
    assertFalse(Double.isFinite(seconds), () -> text + " is " + seconds);
  }

  @Test
  void rejectsSecondNotationInOneFile() {
    Times times = new Times();
    times.seconds("12:00:00");
    assertEquals(Double.NaN, times.seconds("5"));
    assertEquals(Double.NaN, times.seconds("2024-05-31"));
    assertEquals(43_201, times.seconds("12:00:01"));
  }
}
