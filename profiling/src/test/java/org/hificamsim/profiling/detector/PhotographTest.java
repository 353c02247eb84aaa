package org.hificamsim.profiling.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.opencv.core.CvException;

class PhotographTest {
  static Stream<Throwable> failures() {
    return Stream.of(
        new CvException("Failed to allocate 5e9 bytes\nin function 'OutOfMemoryError'"),
        new OutOfMemoryError("Failed to allocate 5e9 bytes"));
  }

  @ParameterizedTest
  @MethodSource("failures")
  void memoryErrorsNamePictureAndDetector(Throwable failure) {
    Photograph photo = new Photograph(Path.of("large.jpg"));
    InputException error =
        assertThrows(InputException.class, () -> photo.detect("sift", () -> thrown(failure)));
    String message = error.getMessage();
    assertTrue(message.startsWith("large.jpg: sift fails"), message);
    assertTrue(message.contains("(Failed to allocate 5e9 bytes)"), message);
    assertEquals(1, message.lines().count());
  }

  private static Object thrown(Throwable failure) {
    if (failure instanceof Error error) {
      throw error;
    }
    throw (RuntimeException) failure;
  }
}
